#include "generator/lsp/server.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "generator/edit/edit.hpp"
#include "generator/files/uri.hpp"
#include "generator/lsp/convert.hpp"
#include "generator/outline/lines.hpp"

namespace eagerx::gen::lsp {
namespace {

// JSON-RPC 2.0, and LSP 3.17 "ErrorCodes".
constexpr int kParseError = -32700, kInvalidRequest = -32600, kMethodNotFound = -32601,
              kInvalidParams = -32602, kServerNotInitialized = -32002;
constexpr int kIncremental = 2;  // TextDocumentSyncKind
constexpr std::size_t kMostDocuments = 1000;
constexpr std::size_t kMostText = 16U << 20U;  // bytes, of a document

bool is_manifest(std::string_view path) {
  return path.ends_with("/manifest.yaml");
}

std::string uri_in(const Json& params) {
  return text_of(member(member(&params, "textDocument"), "uri"));
}

Json location(const std::string& uri, std::string_view text, Bytes bytes) {
  return Json{{"uri", uri}, {"range", range_of(text, bytes)}};
}

/// The entry of the object or node that a port's name begins with, or nullptr.
const OutlineEntry* owner_of(const OutlineNode& top, std::string_view port) {
  const std::string_view owner = port.substr(0, port.find_first_of(".["));
  for (const char* const section : {"objects", "nodes"}) {
    const OutlineNode* const all = top.find(section);
    if (all == nullptr) continue;
    for (const OutlineEntry& entry : all->entries) {
      if (entry.key.substr(0, entry.key.find('[')) == owner) return &entry;
    }
  }
  return nullptr;
}

}  // namespace

void Server::take(std::string_view content) {
  const auto message = parse_json(content);
  if (!message || !message->is<Json::Object>())
    return refuse(nullptr, kParseError, "the message is no JSON object");
  const std::string method = text_of(member(&*message, "method"));
  const Json* const id = member(&*message, "id");
  const Json* const params = member(&*message, "params");
  const Json nothing = Json::object();
  if (method.empty()) {
    // An answer to a request; this server makes none.
    if (id == nullptr || member(&*message, "result") != nullptr || member(&*message, "error"))
      return;
    return refuse(*id, kInvalidRequest, "there is no `method`");
  }
  if (id == nullptr) return notify(method, params != nullptr ? *params : nothing);
  if (shut_down_) return refuse(*id, kInvalidRequest, "the server was shut down");
  respond(*id, answer(method, params != nullptr ? *params : nothing));
}

std::vector<std::string> Server::take_answers() {
  return std::exchange(answers_, {});
}

void Server::send(const std::string& method, Json params) {
  answers_.push_back(
      dump_json(Json{{"jsonrpc", "2.0"}, {"method", method}, {"params", std::move(params)}}));
}
void Server::respond(const Json& id, Answer answer) {
  if (answer.error != 0) return refuse(id, answer.error, answer.message);
  answers_.push_back(
      dump_json(Json{{"jsonrpc", "2.0"}, {"id", id}, {"result", std::move(answer.result)}}));
}
void Server::refuse(const Json& id, int code, const std::string& message) {
  answers_.push_back(dump_json(
      Json{{"jsonrpc", "2.0"}, {"id", id}, {"error", Json{{"code", code}, {"message", message}}}}));
}

Server::Answer Server::answer(const std::string& method, const Json& params) {
  if (method == "initialize") {
    initialized_ = true;
    return {initialize()};
  }
  if (!initialized_) return {{}, kServerNotInitialized, "`initialize` comes first"};
  if (method == "shutdown") {
    shut_down_ = true;
    return {};
  }
  if (!method.starts_with("textDocument/"))
    return {{}, kMethodNotFound, fmt::format("there is no `{}`", method)};
  const Document* const document = document_of(params);
  if (document == nullptr)
    return {{}, kInvalidParams, fmt::format("`{}` is not open", uri_in(params))};
  if (method == "textDocument/documentSymbol") return {symbols(*document)};
  if (method == "textDocument/codeAction") return {actions(*document, params)};
  const auto position = position_in(member(&params, "position"));
  constexpr std::array kAtPositions = {"textDocument/completion",    "textDocument/hover",
                                       "textDocument/definition",    "textDocument/references",
                                       "textDocument/prepareRename", "textDocument/rename"};
  if (std::ranges::find(kAtPositions, method) == kAtPositions.end())
    return {{}, kMethodNotFound, fmt::format("there is no `{}`", method)};
  if (!position) return {{}, kInvalidParams, "`position` is none"};
  if (method == "textDocument/references") return {references(*document, *position)};
  if (method == "textDocument/prepareRename") return {prepare_rename(*document, *position)};
  if (method == "textDocument/rename")
    return renamed(*document, *position, text_of(member(&params, "newName")));
  if (method == "textDocument/completion") return {completion(*document, *position)};
  if (method == "textDocument/hover") return {hover_text(*document, *position)};
  return {definition(*document, *position)};
}

Json Server::initialize() {
  Json capabilities{
      {"positionEncoding", "utf-16"},
      {"textDocumentSync", Json{{"openClose", true}, {"change", kIncremental}, {"save", true}}},
      {"completionProvider",
       Json{{"triggerCharacters", std::vector<std::string>{":", ".", " ", "{", "[", ","}}}},
      {"hoverProvider", true},
      {"definitionProvider", true},
      {"referencesProvider", true},
      {"renameProvider", Json{{"prepareProvider", true}}},
      {"documentSymbolProvider", true},
      {"codeActionProvider", Json{{"codeActionKinds", std::vector<std::string>{"quickfix"}}}}};
  return Json{{"capabilities", std::move(capabilities)},
              {"serverInfo", Json{{"name", "eagerx-gen"}, {"version", EAGERX_GEN_VERSION}}}};
}

void Server::notify(const std::string& method, const Json& params) {
  if (method == "exit") {
    ended_ = true;
  } else if (!initialized_ || shut_down_) {
    return;
  } else if (method == "textDocument/didOpen") {
    open(params);
  } else if (method == "textDocument/didChange") {
    change(params);
  } else if (method == "textDocument/didClose") {
    close(params);
  } else if (method == "textDocument/didSave" || method == "workspace/didChangeWatchedFiles") {
    // Of a manifest, a weight file, another graph: what depends on it is looked at again.
    analyst_.forget();
    for (auto& [uri, document] : documents_) document.changed = true;
  }
}

Server::Document* Server::document_of(const Json& params) {
  const auto found = documents_.find(uri_in(params));
  return found != documents_.end() ? &found->second : nullptr;
}

const LibraryFacts& Server::library_of(const Document& document) {
  return is_manifest(document.path) ? analyst_.of_manifests()
                                    : analyst_.of_graph(document.path, document.text);
}

void Server::open(const Json& params) {
  const std::string uri = uri_in(params);
  const Json* const document = member(&params, "textDocument");
  std::string text = text_of(member(document, "text"));
  if (uri.empty() || documents_.size() >= kMostDocuments || text.size() > kMostText) return;
  Document& here = documents_[uri];
  here.uri = uri;
  here.path = path_of_uri(uri);
  here.text = std::move(text);
  here.version = static_cast<std::int64_t>(number_of(member(document, "version")).value_or(0));
  here.changed = true;
}

void Server::change(const Json& params) {
  Document* const document = document_of(params);
  const Json* const changes = member(&params, "contentChanges");
  if (document == nullptr || changes == nullptr || !changes->is<Json::List>()) return;
  for (const Json& each : *changes->as<Json::List>()) {
    const std::string text = text_of(member(&each, "text"));
    const Json* const range = member(&each, "range");
    if (range == nullptr) {
      if (text.size() <= kMostText) document->text = text;
      continue;
    }
    const auto start = position_in(member(range, "start"));
    const auto end = position_in(member(range, "end"));
    if (!start || !end || document->text.size() + text.size() > kMostText) continue;
    const std::size_t from = byte_at(document->text, *start);
    const std::size_t to = std::max(from, byte_at(document->text, *end));
    document->text.replace(from, to - from, text);
  }
  document->version = static_cast<std::int64_t>(
      number_of(member(member(&params, "textDocument"), "version")).value_or(0));
  document->changed = true;
}

void Server::close(const Json& params) {
  Document* const document = document_of(params);
  if (document == nullptr) return;
  document->diagnostics = {};
  publish(*document);
  documents_.erase(document->uri);
}

void Server::check_changed() {
  for (auto& [uri, document] : documents_) {
    if (std::exchange(document.changed, false)) check(document);
  }
}

void Server::check(Document& document) {
  if (is_manifest(document.path)) return;  // its graphs are checked, which it is part of
  Analyst::Checked checked = analyst_.check(document.path, document.text);
  document.diagnostics = std::move(checked.diagnostics);
  document.sources = std::move(checked.sources);
  publish(document);
}

void Server::publish(Document& document) {
  std::map<std::string, Json> lists;
  for (const std::string& uri : document.told) lists[uri] = Json::list();
  lists[document.uri] = Json::list();
  for (const Diagnostic& each : document.diagnostics.all()) {
    const FileId file = each.span.file;
    const std::string& name = file == FileId::none ? document.path : document.sources.name(file);
    const bool is_here = file == FileId::none || name == document.path;
    const std::string uri = is_here ? document.uri : uri_of_path(name);
    Json one = diagnostic_json(
        each, is_here ? std::string_view(document.text) : document.sources.text(file));
    Json related = Json::list();
    for (const Diagnostic::Note& note : each.notes) {
      if (note.span.file == FileId::none) continue;
      const std::string& other = document.sources.name(note.span.file);
      const std::string& text =
          other == document.path ? document.text : document.sources.text(note.span.file);
      related.push_back(
          Json{{"location", location(other == document.path ? document.uri : uri_of_path(other),
                                     text, bytes_of(text, note.span))},
               {"message", note.message.empty() ? note.label : note.message}});
    }
    one["relatedInformation"] = std::move(related);
    Json& list = lists.try_emplace(uri, Json::list()).first->second;
    list.push_back(std::move(one));
  }
  document.told.clear();
  // The document's own come last: with its version everything is told.
  auto own = lists.extract(document.uri);
  for (auto& [uri, list] : lists) {
    document.told.push_back(uri);
    send("textDocument/publishDiagnostics", Json{{"uri", uri}, {"diagnostics", std::move(list)}});
  }
  send("textDocument/publishDiagnostics", Json{{"uri", document.uri},
                                               {"version", document.version},
                                               {"diagnostics", std::move(own.mapped())}});
}

Json Server::completion(const Document& document, Position position) {
  const std::size_t at = byte_at(document.text, position);
  return completion_json(complete(library_of(document), document.text, at), document.text);
}

Json Server::hover_text(const Document& document, Position position) {
  const Hover found = hover(library_of(document), document.text, byte_at(document.text, position));
  if (found.text.empty()) return nullptr;
  return Json{{"contents", Json{{"kind", "markdown"}, {"value", found.text}}},
              {"range", range_of(document.text, found.word)}};
}

Json Server::definition(const Document& document, Position position) {
  const OutlineNode top = outline_of(document.text);
  const Cursor cursor = cursor_at(document.text, byte_at(document.text, position));
  const std::string word =
      document.text.substr(cursor.word.begin, cursor.word.end - cursor.word.begin);
  if (word.empty() || cursor.is_key) return nullptr;
  const auto* const key =
      cursor.path.empty() ? nullptr : std::get_if<std::string>(&cursor.path.back());
  if (key != nullptr && (*key == "type" || *key == "processor")) {
    const std::string manifest = analyst_.manifest_of(document.path, document.text, word);
    if (!manifest.empty()) return location(uri_of_path(manifest), {}, {});
  }
  if (const OutlineEntry* const owner = owner_of(top, word))
    return location(document.uri, document.text, owner->key_place);
  return nullptr;
}

Json Server::references(const Document& document, Position position) {
  Json result = Json::list();
  const std::string name = name_at(document.text, byte_at(document.text, position));
  for (const Bytes& use : uses_of(document.text, name))
    result.push_back(location(document.uri, document.text, use));
  return result;
}

Json Server::prepare_rename(const Document& document, Position position) {
  const std::size_t at = byte_at(document.text, position);
  const std::string name = name_at(document.text, at);
  for (const Bytes& use : uses_of(document.text, name)) {
    if (use.begin <= at && at <= use.end)
      return Json{{"range", range_of(document.text, use)}, {"placeholder", name}};
  }
  return nullptr;
}

Server::Answer Server::renamed(const Document& document, Position position, const std::string& to) {
  const std::string name = name_at(document.text, byte_at(document.text, position));
  const auto edit = rename(document.text, name, to);
  if (name.empty()) return {{}, kInvalidParams, "no object and no node is named here"};
  if (!edit) return {{}, kInvalidParams, fmt::format("`{}` is taken, or cannot be a name", to)};
  // A name that is written where nobody looked for it is an error now.
  const auto now = analyst_.check(document.path, applied(document.text, edit->splices));
  const auto before = analyst_.check(document.path, document.text);
  if (now.diagnostics.error_count() > before.diagnostics.error_count()) {
    const auto& first = now.diagnostics.all().front();
    return {{}, kInvalidParams, fmt::format("the graph would have an error: {}", first.message)};
  }
  return {edit_json(*edit, document.uri, document.text)};
}

Json Server::symbols(const Document& document) {
  return symbols_json(outline_of(document.text), document.text);
}

Json Server::actions(const Document& document, const Json& params) {
  Json result = Json::list();
  const auto start = position_in(member(member(&params, "range"), "start"));
  const auto end = position_in(member(member(&params, "range"), "end"));
  if (!start || !end || document.changed) return result;
  for (const Diagnostic& each : document.diagnostics.all()) {
    const FileId file = each.span.file;
    if (file == FileId::none || document.sources.name(file) != document.path) continue;
    const auto fix = fix_of(each, document.text);
    if (!fix) continue;
    const Bytes place = fix->splices.front().place;
    if (place.end < byte_at(document.text, *start) || place.begin > byte_at(document.text, *end))
      continue;
    Json diagnostics = Json::list();
    diagnostics.push_back(diagnostic_json(each, document.text));
    result.push_back(Json{{"title", fix->reason},
                          {"kind", "quickfix"},
                          {"isPreferred", true},
                          {"diagnostics", std::move(diagnostics)},
                          {"edit", edit_json(*fix, document.uri, document.text)}});
  }
  return result;
}

}  // namespace eagerx::gen::lsp
