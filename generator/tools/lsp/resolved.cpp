#include "generator/tools/lsp/resolved.hpp"

#include <fmt/format.h>

#include <utility>

namespace eagerx::gen::lsp {
namespace {

void join(std::string& text, const std::string& more) {
  if (!more.empty()) text += (text.empty() ? "" : ", ") + more;
}

std::string text_of(const Resolved::Connection& connection) {
  std::string text = connection.per_tick;
  if (!connection.age.empty()) join(text, "≤ " + connection.age);
  join(text, connection.defaulted);
  return text;
}

bool is_within(std::size_t at, Bytes within) {
  return within.begin <= at && at <= within.end;
}

void of_connections(const OutlineNode& graph, const Resolved& resolved, Bytes within,
                    std::vector<InlayHint>& hints) {
  const OutlineNode* const all = graph.find("connections");
  if (all == nullptr) return;
  for (const OutlineEntry& item : all->entries) {
    const OutlineNode* const to = item.value.find("to");
    if (to == nullptr || to->text.empty() || !is_within(to->place.end, within)) continue;
    const auto found = resolved.connections.find(without_indices(to->text));
    if (found == resolved.connections.end()) continue;
    std::string about = found->second.about;
    hints.push_back({to->place.end, text_of(found->second), std::move(about)});
  }
}

/// Objects and nodes without a rate of their own.
void of_owners(const char* section, const OutlineNode& graph, const Resolved& resolved,
               Bytes within, std::vector<InlayHint>& hints) {
  const OutlineNode* const all = graph.find(section);
  if (all == nullptr) return;
  for (const OutlineEntry& node : all->entries) {
    const OutlineNode* const type = node.value.find("type");
    if (type == nullptr || node.value.find("rate") != nullptr ||
        !is_within(type->place.end, within))
      continue;
    const auto found = resolved.rates.find(without_indices(node.key));
    if (found != resolved.rates.end()) hints.push_back({type->place.end, found->second, {}});
  }
}

}  // namespace

std::string without_indices(std::string_view name) {
  std::string result;
  int depth = 0;
  for (const char c : name) {
    if (c == '[') ++depth;
    if (depth == 0) result += c;
    if (c == ']' && depth > 0) --depth;
  }
  return result;
}

std::vector<InlayHint> inlay_hints(const OutlineNode& graph, const Resolved& resolved,
                                   Bytes within) {
  std::vector<InlayHint> hints;
  of_owners("objects", graph, resolved, within, hints);
  of_owners("nodes", graph, resolved, within, hints);
  of_connections(graph, resolved, within, hints);
  return hints;
}

}  // namespace eagerx::gen::lsp
