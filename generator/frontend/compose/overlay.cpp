#include "generator/frontend/compose/overlay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "generator/frontend/compose/port_bindings.hpp"
#include "generator/frontend/spec/format.hpp"
#include "generator/frontend/spec/port_name.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

constexpr const char* kRemove = "remove";
constexpr const char* kConnections = "connections";
constexpr const char* kStates = "states";

std::string text_at(const YamlValue& map, const char* key) {
  const YamlValue* value = map.find(key);
  return value != nullptr && value->is_scalar() ? value->text : std::string();
}

/// A connection to the same port takes the place of the one below.
void lay_over_connections(YamlValue& base, YamlValue over) {
  for (auto& item : over.items) {
    const std::string to = text_at(item, "to");
    const auto same = ranges::find_if(
        base.items, [&](const YamlValue& each) { return text_at(each, "to") == to; });
    if (to.empty() || same == base.items.end())
      base.items.push_back(std::move(item));
    else
      *same = std::move(item);
  }
}

/// Ways to sample a state: another one takes the place of the one below.
constexpr std::array<std::string_view, 5> kWays{"value", "uniform", "normal", "log_uniform",
                                                "choice"};

bool is_way(const YamlValue::Entry& entry) {
  return ranges::contains(kWays, std::string_view(entry.key));
}

void drop_other_ways(YamlValue& base, const YamlValue& over) {
  if (!ranges::any_of(over.entries, is_way)) return;
  std::erase_if(base.entries, [&](const auto& entry) {
    return is_way(entry) && over.find(entry.key) == nullptr;
  });
}

/// The kind of a mapping's entries.
enum class Level : std::uint8_t { top, states, other };

void lay_over(YamlValue& base, YamlValue over, Level level) {
  const std::string type = text_at(base, "type");
  const std::string other = text_at(over, "type");
  const bool merge =
      base.is_map() && over.is_map() && (type.empty() || other.empty() || type == other);
  if (!merge) {
    base = std::move(over);
    return;
  }
  for (auto& entry : over.entries) {
    const auto below = ranges::find(base.entries, entry.key, &YamlValue::Entry::key);
    if (below == base.entries.end()) {
      base.entries.push_back(std::move(entry));
    } else if (level == Level::top && entry.key == kConnections && below->value.is_sequence() &&
               entry.value.is_sequence()) {
      lay_over_connections(below->value, std::move(entry.value));
    } else {
      below->key_span = entry.key_span;
      if (level == Level::states) drop_other_ways(below->value, entry.value);
      const Level next = entry.key == kStates ? Level::states : Level::other;
      lay_over(below->value, std::move(entry.value), next);
    }
  }
}

/// Keys may have dots themselves: `body.mass` is a state of what is in a composite.
YamlValue::Entry* entry_at(YamlValue& yaml, std::string_view path, std::string_view& rest) {
  for (auto& entry : yaml.entries) {
    const bool leads = path.starts_with(entry.key) &&
                       (path.size() == entry.key.size() || path[entry.key.size()] == '.');
    if (!leads) continue;
    rest = path.substr(std::min(path.size(), entry.key.size() + 1));
    return &entry;
  }
  return nullptr;
}

/// Takes the entry, item or connection away that `path` names; false if there is none.
bool take_away(YamlValue& yaml, std::string_view path, bool top) {
  if (std::erase_if(yaml.items, [&](const YamlValue& each) {
        return each.is_scalar() && each.text == path;
      }) > 0)
    return true;
  std::string_view rest;
  YamlValue::Entry* const found = entry_at(yaml, path, rest);
  if (found == nullptr) return false;
  if (rest.empty())
    return std::erase_if(yaml.entries, [&](const auto& each) { return each.key == path; }) > 0;
  if (top && found->key == kConnections)
    return std::erase_if(found->value.items,
                         [&](const YamlValue& each) { return text_at(each, "to") == rest; }) > 0;
  return take_away(found->value, rest, false);
}

/// Candidates for a suggestion: the keys next to the missing one.
std::vector<std::string> sibling_names(YamlValue& graph, std::string_view path) {
  YamlValue* at = &graph;
  std::string prefix;
  for (std::string_view rest; YamlValue::Entry* const next = entry_at(*at, path, rest);) {
    if (rest.empty()) break;
    at = &next->value;
    prefix += next->key + ".";
    path = rest;
  }
  std::vector<std::string> names;
  for (const auto& entry : at->entries) names.push_back(prefix + entry.key);
  for (const auto& item : at->items)
    names.push_back(prefix + (item.is_scalar() ? item.text : text_at(item, "to")));
  return names;
}

void remove_named(YamlValue& graph, const YamlValue& list, Diagnostics& diagnostics) {
  static const FormatPtr kFormat =
      format::list("a list such as `[nodes.filter, connections.motor.u]`", format::text("a path"));
  if (!check(list, *kFormat, diagnostics)) return;
  for (const auto& item : list.items) {
    if (take_away(graph, item.text, true)) {
      YamlValue& gone = map_at(graph, kRemovedEntities, item.span);
      set_entry(gone, item.text, item.span, made_scalar("", item.span));
      continue;
    }
    auto& problem =
        diagnostics.error("E0395", item.span, fmt::format("there is no `{}` to remove", item.text));
    problem.help = did_you_mean(item.text, sibling_names(graph, item.text),
                                "write the keys that lead to it, with dots: `nodes.filter`; a "
                                "connection by where it goes: `connections.motor.u`");
  }
}

}  // namespace

YamlValue laid_over(YamlValue base, YamlValue over, Diagnostics& diagnostics) {
  if (const YamlValue* list = over.find(kRemove)) remove_named(base, *list, diagnostics);
  std::erase_if(over.entries, [](const auto& entry) { return entry.key == kRemove; });
  lay_over(base, std::move(over), Level::top);
  return base;
}

void check_removed(const YamlValue& graph, Diagnostics& diagnostics) {
  const YamlValue* removed = graph.find(kRemovedEntities);
  const YamlValue* connections = graph.find(kConnections);
  if (removed == nullptr || connections == nullptr) return;
  for (const auto& connection : connections->items) {
    for (const char* side : {"from", "to"}) {
      const YamlValue* port = connection.find(side);
      if (port == nullptr) continue;
      const PortName name = parse_port(port->text);
      for (const char* section : {"nodes", "objects"}) {
        const auto gone = ranges::find(removed->entries, fmt::format("{}.{}", section, name.owner),
                                       &YamlValue::Entry::key);
        const YamlValue* now = graph.find(section);
        if (gone == removed->entries.end() || (now != nullptr && now->find(name.owner) != nullptr))
          continue;
        auto& problem = diagnostics.error(
            "E0395", gone->key_span, fmt::format("`{}` is removed, but still used", name.owner));
        problem.notes.push_back({"by this connection", port->span, ""});
        problem.help = fmt::format(
            "remove the connection, too (`connections.{}`), or connect "
            "something else there",
            text_at(connection, "to"));
      }
    }
  }
}

}  // namespace eagerx::gen
