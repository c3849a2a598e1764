#include "generator/lsp/convert.hpp"

#include <fmt/format.h>

#include <utility>

#include "generator/outline/lines.hpp"

namespace eagerx::gen::lsp {
namespace {

Json json_of(Position position) {
  return Json{{"line", position.line}, {"character", position.character}};
}

// LSP 3.17: DiagnosticSeverity, CompletionItemKind, SymbolKind.
constexpr int kError = 1, kWarning = 2, kInformation = 3;
constexpr int kReference = 18, kProperty = 10, kEnumMember = 20;
constexpr int kNamespace = 3, kClass = 5, kField = 8, kArray = 18;

int kind_of(Proposal::Kind kind) {
  if (kind == Proposal::Kind::port) return kReference;
  return kind == Proposal::Kind::key ? kProperty : kEnumMember;
}

Json symbol(const std::string& name, int kind, const OutlineEntry& entry, std::string_view text,
            const std::string& detail) {
  std::size_t end = entry.whole.end;
  while (end > entry.whole.begin && (text[end - 1] == '\n' || text[end - 1] == ' ')) --end;
  const Bytes whole{entry.whole.begin, end};
  const Bytes chosen = entry.key.empty() ? Bytes{whole.begin, whole.begin} : entry.key_place;
  return Json{{"name", name},
              {"detail", detail},
              {"kind", kind},
              {"range", range_of(text, whole)},
              {"selectionRange", range_of(text, chosen)}};
}

std::string text_at(const OutlineNode& node, std::string_view key) {
  const OutlineNode* const value = node.find(key);
  return value != nullptr ? value->text : std::string();
}

}  // namespace

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
  if (!diagnostic.help.empty()) message += "\nhelp: " + diagnostic.help;
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
    items.push_back(Json{
        {"label", each.label},
        {"kind", kind_of(each.kind)},
        {"documentation", each.about},
        {"sortText", fmt::format("{:05}", rank++)},
        {"filterText", each.label},
        {"textEdit", Json{{"range", range_of(text, completion.word)}, {"newText", each.insert}}}});
  }
  return Json{{"isIncomplete", false}, {"items", std::move(items)}};
}

Json symbols_json(const OutlineNode& top, std::string_view text) {
  Json result = Json::list();
  if (top.kind != OutlineNode::Kind::map) return result;
  for (const OutlineEntry& section : top.entries) {
    if (section.key.empty()) continue;
    Json one = symbol(section.key, kNamespace, section, text, section.value.text);
    Json children = Json::list();
    for (const OutlineEntry& each : section.value.entries) {
      if (!each.key.empty()) {
        const bool is_owner = section.key == "objects" || section.key == "nodes";
        children.push_back(symbol(each.key, is_owner ? kClass : kField, each, text,
                                  is_owner ? text_at(each.value, "type") : each.value.text));
      } else if (section.key == "connections") {
        const std::string from = text_at(each.value, "from"), to = text_at(each.value, "to");
        children.push_back(symbol(fmt::format("{} → {}", from, to), kArray, each, text, {}));
      }
    }
    one["children"] = std::move(children);
    result.push_back(std::move(one));
  }
  return result;
}

Json edit_json(const Edit& edit, const std::string& uri, std::string_view text) {
  Json edits = Json::list();
  for (const Splice& splice : edit.splices)
    edits.push_back(Json{{"range", range_of(text, splice.place)}, {"newText", splice.text}});
  Json changes = Json::object();
  changes[uri] = std::move(edits);
  return Json{{"changes", std::move(changes)}};
}

}  // namespace eagerx::gen::lsp
