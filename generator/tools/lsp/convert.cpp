#include "generator/tools/lsp/convert.hpp"

#include <fmt/format.h>

#include <utility>

#include "generator/frontend/outline/lines.hpp"
#include "generator/tools/edit/words.hpp"

namespace eagerx::gen::lsp {
namespace {

Json json_of(Position position) {
  return Json{{"line", position.line}, {"character", position.character}};
}

// LSP 3.17: DiagnosticSeverity, CompletionItemKind, SymbolKind.
constexpr int kError = 1, kWarning = 2, kInformation = 3;
constexpr int kReference = 18, kProperty = 10, kEnumMember = 20, kSnippet = 15;
constexpr int kSnippetFormat = 2;  // InsertTextFormat
constexpr int kNamespace = 3, kClass = 5, kField = 8, kArray = 18;

int kind_of(Proposal::Kind kind) {
  if (kind == Proposal::Kind::port) return kReference;
  if (kind == Proposal::Kind::snippet) return kSnippet;
  return kind == Proposal::Kind::key ? kProperty : kEnumMember;
}

Json range_of(const Lines& lines, Bytes bytes) {
  return Json{{"start", json_of(lines.position(bytes.begin))},
              {"end", json_of(lines.position(bytes.end))}};
}

/// A text, and where its lines are.
struct Text {
  std::string_view text;
  Lines lines = Lines(text);
};

Json symbol(const std::string& name, int kind, const OutlineEntry& entry, const Text& where,
            const std::string& detail) {
  const std::string_view text = where.text;
  std::size_t end = entry.whole.end;
  while (end > entry.whole.begin && (text[end - 1] == '\n' || text[end - 1] == ' ')) --end;
  const Bytes whole{entry.whole.begin, end};
  const Bytes chosen = entry.key.empty() ? Bytes{whole.begin, whole.begin} : entry.key_place;
  return Json{{"name", name},
              {"detail", detail},
              {"kind", kind},
              {"range", range_of(where.lines, whole)},
              {"selectionRange", range_of(where.lines, chosen)}};
}

}  // namespace

bool is_manifest(std::string_view path) {
  return path.ends_with("/manifest.yaml");
}

Json location_json(const std::string& uri, std::string_view text, Bytes bytes) {
  return Json{{"uri", uri}, {"range", range_of(text, bytes)}};
}

Json range_of(std::string_view text, Bytes bytes) {
  return Json{{"start", json_of(position_at(text, bytes.begin))},
              {"end", json_of(position_at(text, bytes.end))}};
}

std::optional<Position> position_in(const Json* json) {
  constexpr double kMost = 2147483647.0;  // LSP's uinteger
  const auto line = number_of(member(json, "line"));
  const auto character = number_of(member(json, "character"));
  if (!line || !character || *line < 0 || *character < 0 || *line > kMost || *character > kMost)
    return std::nullopt;
  return Position{static_cast<std::uint32_t>(*line), static_cast<std::uint32_t>(*character)};
}

Json diagnostic_json(const Diagnostic& diagnostic, std::string_view text) {
  std::string message = diagnostic.message;
  if (!diagnostic.label.empty()) message += ": " + diagnostic.label;
  if (!diagnostic.help.empty()) message += "\nhelp: " + diagnostic.help.text;
  const bool is_error = diagnostic.severity == Severity::error;
  const bool is_warning = diagnostic.severity == Severity::warning;
  return Json{{"range", range_of(text, bytes_of(text, diagnostic.span))},
              {"severity", is_error     ? kError
                           : is_warning ? kWarning
                                        : kInformation},
              {"code", diagnostic.code},
              {"source", "eagerx-gen"},
              {"message", std::move(message)}};
}

Json completion_json(const Completion& completion, std::string_view text) {
  Json items = Json::list();
  std::size_t rank = 0;
  for (const Proposal& each : completion.proposals) {
    Json item{
        {"label", each.label},
        {"kind", kind_of(each.kind)},
        {"documentation", each.about},
        {"sortText", fmt::format("{:05}", rank++)},
        {"filterText", each.filter.empty() ? each.label : each.filter},
        {"textEdit", Json{{"range", range_of(text, completion.word)}, {"newText", each.insert}}}};
    if (each.kind == Proposal::Kind::snippet) item["insertTextFormat"] = kSnippetFormat;
    items.push_back(std::move(item));
  }
  return Json{{"isIncomplete", false}, {"items", std::move(items)}};
}

Json symbols_json(const OutlineNode& top, std::string_view text) {
  Json result = Json::list();
  if (top.kind != OutlineNode::Kind::map) return result;
  const Text where{text};
  for (const OutlineEntry& section : top.entries) {
    if (section.key.empty()) continue;
    Json one = symbol(section.key, kNamespace, section, where, section.value.text);
    Json children = Json::list();
    for (const OutlineEntry& each : section.value.entries) {
      if (!each.key.empty()) {
        const bool is_owner = section.key == "objects" || section.key == "nodes";
        children.push_back(symbol(each.key, is_owner ? kClass : kField, each, where,
                                  is_owner ? text_at(each.value, "type") : each.value.text));
      } else if (section.key == "connections") {
        const std::string from = text_at(each.value, "from"), to = text_at(each.value, "to");
        children.push_back(symbol(fmt::format("{} → {}", from, to), kArray, each, where, {}));
      }
    }
    one["children"] = std::move(children);
    result.push_back(std::move(one));
  }
  return result;
}

Json edit_json(const Edit& edit, const std::string& uri, std::string_view text) {
  return edits_json({{uri, splices_json(edit.splices, text)}});
}

Json edits_json(const std::vector<std::pair<std::string, Json>>& of_documents) {
  Json changes = Json::object();
  for (const auto& [uri, edits] : of_documents) changes[uri] = edits;
  return Json{{"changes", std::move(changes)}};
}

Json splices_json(const std::vector<Splice>& splices, std::string_view text) {
  const Lines lines(text);
  Json edits = Json::list();
  for (const Splice& splice : splices)
    edits.push_back(Json{{"range", range_of(lines, splice.place)}, {"newText", splice.text}});
  return edits;
}

Json hints_json(const std::vector<InlayHint>& hints, std::string_view text) {
  const Lines lines(text);
  Json result = Json::list();
  for (const InlayHint& hint : hints) {
    Json one{{"position", json_of(lines.position(hint.at))},
             {"label", hint.text},
             {"paddingLeft", true}};
    if (!hint.about.empty()) one["tooltip"] = Json{{"kind", "markdown"}, {"value", hint.about}};
    result.push_back(std::move(one));
  }
  return result;
}

Json folds_json(const std::vector<Fold>& folds) {
  Json result = Json::list();
  for (const Fold& fold : folds)
    result.push_back(Json{{"startLine", fold.first},
                          {"endLine", fold.last},
                          {"kind", fold.is_comment ? "comment" : "region"}});
  return result;
}

}  // namespace eagerx::gen::lsp
