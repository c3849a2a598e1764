#include "generator/tools/lsp/server.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <utility>

#include "generator/frontend/outline/lines.hpp"
#include "generator/support/files/uri.hpp"
#include "generator/tools/lsp/convert.hpp"
#include "generator/tools/lsp/errors.hpp"

namespace eagerx::gen::lsp {
namespace {

constexpr int kIncremental = 2;  // TextDocumentSyncKind
constexpr std::size_t kMostDocuments = 1000;
constexpr std::size_t kMostText = 16U << 20U;  // bytes, of a document

std::string uri_in(const Json& params) {
  return text_of(member(member(&params, "textDocument"), "uri"));
}

}  // namespace

void Server::take(std::string_view content) {
  const auto message = parse_json(content);
  if (!message || !message->is<Json::Object>())
    return refuse(nullptr, kParseError, "the message is not a JSON object");
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
    return {initialize(params)};
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
  return of_document(method, *document, params);
}

Json Server::initialize(const Json& params) {
  const auto can = [&](std::initializer_list<const char*> path) {
    const Json* at = member(&params, "capabilities");
    for (const char* const key : path) at = member(at, key);
    return truth_of(at).value_or(false);
  };
  takes_snippets_ = can({"textDocument", "completion", "completionItem", "snippetSupport"});
  watches_ = can({"workspace", "didChangeWatchedFiles", "dynamicRegistration"});
  watches_folders_ = can({"workspace", "didChangeWatchedFiles", "relativePatternSupport"});
  refreshes_ = can({"workspace", "inlayHint", "refreshSupport"});
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
      {"foldingRangeProvider", true},
      {"inlayHintProvider", true},
      {"codeActionProvider", Json{{"codeActionKinds", std::vector<std::string>{"quickfix"}}}}};
  return Json{{"capabilities", std::move(capabilities)},
              {"serverInfo", Json{{"name", "eagerx-gen"}, {"version", EAGERX_GEN_VERSION}}}};
}

void Server::ask(const std::string& method, Json params) {
  Json request{
      {"jsonrpc", "2.0"}, {"id", fmt::format("eagerx-gen/{}", ++asked_)}, {"method", method}};
  if (!params.is<std::monostate>()) request["params"] = std::move(params);
  answers_.push_back(dump_json(request));
}

void Server::initialized() {
  if (!watches_) return;
  // Graphs, manifests, tables, weights, and headers of entities.
  const std::string files = "**/*.{yaml,csv,hpp,onnx,safetensors,pt,pth,zip,pkl,npz,json}";
  Json watchers = Json::list();
  watchers.push_back(Json{{"globPattern", files}});
  for (const std::string& folder : analyst_.folders()) {
    if (watches_folders_)
      watchers.push_back(
          Json{{"globPattern", Json{{"baseUri", uri_of_path(folder)}, {"pattern", files}}}});
  }
  Json registration{{"id", "files"},
                    {"method", "workspace/didChangeWatchedFiles"},
                    {"registerOptions", Json{{"watchers", std::move(watchers)}}}};
  Json registrations = Json::list();
  registrations.push_back(std::move(registration));
  ask("client/registerCapability", Json{{"registrations", std::move(registrations)}});
}

void Server::notify(const std::string& method, const Json& params) {
  if (method == "exit") {
    ended_ = true;
  } else if (!initialized_ || shut_down_) {
    return;
  } else if (method == "initialized") {
    initialized();
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
  analyst_.set_text(here.path, here.text);
  mark_users_of(here);
}

void Server::mark_users_of(const Document& document) {
  for (auto& [uri, other] : documents_) {
    const bool uses = is_manifest(document.path) ? !is_manifest(other.path)
                                                 : other.text.find("extends:") != std::string::npos;
    other.changed = other.changed || (uses && uri != document.uri);
  }
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
  analyst_.set_text(document->path, document->text);
  mark_users_of(*document);
}

void Server::close(const Json& params) {
  Document* const document = document_of(params);
  if (document == nullptr) return;
  document->diagnostics = {};
  publish(*document);
  analyst_.set_text(document->path, std::nullopt);
  mark_users_of(*document);
  documents_.erase(document->uri);
}

void Server::check_changed() {
  bool is_new = false;
  for (auto& [uri, document] : documents_) {
    if (!std::exchange(document.changed, false)) continue;
    check(document);
    is_new = true;
  }
  if (is_new && refreshes_) ask("workspace/inlayHint/refresh", nullptr);
}

void Server::check(Document& document) {
  Analyst::Checked checked = analyst_.check(document.path, document.text);
  document.diagnostics = std::move(checked.diagnostics);
  document.sources = std::move(checked.sources);
  publish(document);
}

void Server::publish(Document& document) {
  std::map<std::string, Json> lists;
  for (const std::string& uri : document.reported) lists[uri] = Json::list();
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
      related.push_back(Json{
          {"location", location_json(other == document.path ? document.uri : uri_of_path(other),
                                     text, bytes_of(text, note.span))},
          {"message", note.message.empty() ? note.label : note.message}});
    }
    one["relatedInformation"] = std::move(related);
    Json& list = lists.try_emplace(uri, Json::list()).first->second;
    list.push_back(std::move(one));
  }
  document.reported.clear();
  // The document's own come last: its version completes the diagnostics.
  auto own = lists.extract(document.uri);
  for (auto& [uri, list] : lists) {
    document.reported.push_back(uri);
    send("textDocument/publishDiagnostics", Json{{"uri", uri}, {"diagnostics", std::move(list)}});
  }
  send("textDocument/publishDiagnostics", Json{{"uri", document.uri},
                                               {"version", document.version},
                                               {"diagnostics", std::move(own.mapped())}});
}

}  // namespace eagerx::gen::lsp
