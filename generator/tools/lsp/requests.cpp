// Requests about an open document.
#include <fmt/format.h>

#include <array>
#include <utility>

#include "generator/frontend/outline/fixes.hpp"
#include "generator/frontend/outline/lines.hpp"
#include "generator/support/diagnostics/search.hpp"
#include "generator/support/files/uri.hpp"
#include "generator/tools/edit/rename_port.hpp"
#include "generator/tools/lsp/convert.hpp"
#include "generator/tools/lsp/errors.hpp"
#include "generator/tools/lsp/server.hpp"

namespace eagerx::gen::lsp {
namespace {

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

Server::Answer Server::of_document(const std::string& method, const Document& document,
                                   const Json& params) {
  if (method == "textDocument/documentSymbol")
    return {symbols_json(outline_of(document.text), document.text)};
  if (method == "textDocument/foldingRange") return {folds_json(folds_of(document.text))};
  if (method == "textDocument/inlayHint") return {hints(document, params)};
  if (method == "textDocument/codeAction") return {actions(document, params)};
  return at_position(method, document, params);
}

Server::Answer Server::at_position(const std::string& method, const Document& document,
                                   const Json& params) {
  const auto position = position_in(member(&params, "position"));
  constexpr std::array kAtPositions = {"textDocument/completion",    "textDocument/hover",
                                       "textDocument/definition",    "textDocument/references",
                                       "textDocument/prepareRename", "textDocument/rename"};
  if (!ranges::contains(kAtPositions, method))
    return {{}, kMethodNotFound, fmt::format("there is no `{}`", method)};
  if (!position) return {{}, kInvalidParams, "`position` is none"};
  if (method == "textDocument/references") return {references(document, *position)};
  if (method == "textDocument/prepareRename") return {prepare_rename(document, *position)};
  if (method == "textDocument/rename")
    return renamed(document, *position, gen::text_of(member(&params, "newName")));
  if (method == "textDocument/completion") return {completion(document, *position)};
  if (method == "textDocument/hover") return {hover_text(document, *position)};
  return {definition(document, *position)};
}

Json Server::completion(const Document& document, Position position) {
  const std::size_t at = byte_at(document.text, position);
  return completion_json(complete(library_of(document), document.text, at, takes_snippets_),
                         document.text);
}

Json Server::hover_text(const Document& document, Position position) {
  const auto resolved = analyst_.resolved(document.path);
  const Hover found =
      hover(library_of(document), document.text, byte_at(document.text, position), resolved.get());
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
    if (const auto files = analyst_.files_of(document.path, document.text, word))
      return location_json(uri_of_path(files->manifest), {}, {});
  }
  if (const OutlineEntry* const owner = owner_of(top, word))
    return location_json(document.uri, document.text, owner->key_place);
  return nullptr;
}

Json Server::references(const Document& document, Position position) {
  Json result = Json::list();
  const std::size_t at = byte_at(document.text, position);
  std::vector<Bytes> uses = uses_of(document.text, name_at(document.text, at));
  if (uses.empty()) {
    if (const auto port = port_in_graph(document.text, at))
      uses = uses_of_port(document.text, port->type, port->port);
  }
  for (const Bytes& use : uses) result.push_back(location_json(document.uri, document.text, use));
  return result;
}

Json Server::prepare_rename(const Document& document, Position position) {
  const std::size_t at = byte_at(document.text, position);
  const std::string name = name_at(document.text, at);
  for (const Bytes& use : uses_of(document.text, name)) {
    if (use.begin <= at && at <= use.end)
      return Json{{"range", range_of(document.text, use)}, {"placeholder", name}};
  }
  const auto port = port_at(document, position);
  if (!port) return nullptr;
  return Json{{"range", range_of(document.text, port->place)}, {"placeholder", port->port}};
}

Server::Answer Server::renamed(const Document& document, Position position, const std::string& to) {
  const std::string name = name_at(document.text, byte_at(document.text, position));
  if (name.empty()) {
    const auto port = port_at(document, position);
    return port ? port_renamed(*port, to)
                : Answer{{}, kInvalidParams, "no object, no node and no port of one is named here"};
  }
  const auto edit = rename(document.text, name, to);
  if (!edit) return {{}, kInvalidParams, fmt::format("`{}` is taken, or cannot be a name", to)};
  const std::string why = why_not({{document.path, document.uri, document.text, edit->splices}});
  if (!why.empty()) return {{}, kInvalidParams, why};
  return {edit_json(*edit, document.uri, document.text)};
}

Json Server::hints(const Document& document, const Json& params) {
  const auto resolved = analyst_.resolved(document.path);
  const auto start = position_in(member(member(&params, "range"), "start"));
  const auto end = position_in(member(member(&params, "range"), "end"));
  if (!resolved || !start || !end) return Json::list();
  const Bytes within{byte_at(document.text, *start), byte_at(document.text, *end)};
  return hints_json(inlay_hints(outline_of(document.text), *resolved, within), document.text);
}

Json Server::actions(const Document& document, const Json& params) {
  Json result = Json::list();
  const auto start = position_in(member(member(&params, "range"), "start"));
  const auto end = position_in(member(member(&params, "range"), "end"));
  if (!start || !end || document.changed) return result;
  const Bytes asked{byte_at(document.text, *start), byte_at(document.text, *end)};
  for (const Diagnostic& each : document.diagnostics.all()) {
    const FileId file = each.span.file;
    if (file == FileId::none || document.sources.name(file) != document.path) continue;
    const Bytes place = bytes_of(document.text, each.span);
    if (place.end < asked.begin || place.begin > asked.end) continue;
    for (const TextFix& fix : fixes_of(each, document.text)) {
      Json diagnostics = Json::list();
      diagnostics.push_back(diagnostic_json(each, document.text));
      result.push_back(Json{{"title", fix.edit.reason},
                            {"kind", "quickfix"},
                            {"isPreferred", fix.is_certain},
                            {"diagnostics", std::move(diagnostics)},
                            {"edit", edit_json(fix.edit, document.uri, document.text)}});
    }
  }
  return result;
}

}  // namespace eagerx::gen::lsp
