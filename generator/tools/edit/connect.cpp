// Adds connections, and removes entries with everything that depends on them.
#include <fmt/format.h>

#include <utility>

#include "generator/support/diagnostics/search.hpp"
#include "generator/support/quote/quote.hpp"
#include "generator/tools/edit/changes.hpp"
#include "generator/tools/edit/words.hpp"

namespace eagerx::gen {
namespace {

/// The same on lines of a list's item.
std::vector<std::string> lines_of_item(const std::vector<KeyValue>& values) {
  std::vector<std::string> lines;
  lines.reserve(values.size());
  for (const KeyValue& each : values)
    lines.push_back(
        fmt::format("{}{}: {}", lines.empty() ? "- " : "  ", yaml_text(each.key), each.value));
  return lines;
}

/// Whether a port is one of `owner`: "pendulum.theta", "leg[2].q", "arm/position.u".
bool is_port_of(std::string_view port, std::string_view owner) {
  if (port == owner) return true;
  return port.size() > owner.size() && port.starts_with(owner) &&
         std::string_view(".[/").find(port[owner.size()]) != std::string_view::npos;
}

/// The last connection with a port of `owner`, as an index; nothing: there is none.
std::optional<std::size_t> connection_of(const Written& written, const std::string& owner) {
  const OutlineNode* const all = written.top().find("connections");
  if (all == nullptr || all->kind != OutlineNode::Kind::list) return std::nullopt;
  for (std::size_t i = all->entries.size(); i-- > 0;) {
    const OutlineNode& each = all->entries[i].value;
    if (is_port_of(text_at(each, "from"), owner) || is_port_of(text_at(each, "to"), owner))
      return i;
  }
  return std::nullopt;
}

/// Takes away what only makes sense with the entry.
bool take_away_uses(Written& written, const std::string& owner) {
  while (const auto index = connection_of(written, owner)) {
    if (!take_away(written, {"connections", *index})) return false;
  }
  const OutlineNode* const render = written.top().find("render");
  if (render == nullptr || !is_port_of(text_at(*render, "source"), owner)) return true;
  return take_away(written, {"render"});
}

/// An item of a list of names as a path with its place: `observations.angle` of `[angle]`.
OutlinePath with_places(const Written& written, OutlinePath path) {
  for (std::size_t i = 1; i <= path.size(); ++i) {
    const OutlineNode* const above = written.node(beginning_of(path, i - 1));
    if (above == nullptr || above->kind != OutlineNode::Kind::list) continue;
    const std::string key = key_at(path, i - 1);
    if (key.empty()) continue;
    for (std::size_t place = 0; place < above->entries.size(); ++place) {
      if (above->entries[place].value.text == key) path[i - 1] = place;
    }
  }
  return path;
}

/// If a connection names a port that its owner's list does not have, adds it there.
bool choose_port(Written& written, const std::string& port, bool sends) {
  const std::size_t dot = port.rfind('.');
  const std::string owner = port.substr(0, port.find_first_of(".[/"));
  if (dot == std::string::npos || port.find('/') != std::string::npos) return true;
  const std::string name = port.substr(dot + 1);
  if (!is_name(name)) return true;
  for (const char* const section : kEntitySections) {
    const bool is_object = std::string_view(section) == "objects";
    const std::string list =
        is_object ? (sends ? "sensors" : "actuators") : (sends ? "outputs" : "inputs");
    const OutlinePath path{section, owner, list};
    const OutlineNode* const chosen = written.node(path);
    if (chosen == nullptr ||
        (chosen->kind != OutlineNode::Kind::list && chosen->kind != OutlineNode::Kind::map))
      continue;
    const bool has = ranges::any_of(chosen->entries, [&](const OutlineEntry& entry) {
      return entry.key == name || entry.value.text == name;
    });
    if (!has && !add_name(written, path, name)) return false;
  }
  return true;
}

}  // namespace

Change remove_entry(std::string_view text, const OutlinePath& written_path) {
  const Written before(text);
  const OutlinePath path = with_places(before, written_path);
  const OutlineEntry* const entry = before.entry(path);
  const std::string name = shown(written_path);
  if (entry == nullptr) return refused(fmt::format("there is no `{}`", name));
  Written after = before;
  const std::string section = key_at(path, 0);
  std::string owner;
  if (path.size() == 2 && is_among(kEntitySections, section)) owner = key_at(path, 1);
  if (path.size() == 2 && is_among(kAgentSections, section))
    owner = section + "." + (entry->key.empty() ? entry->value.text : entry->key);
  const bool done =
      take_away(after, path) &&
      content_of(before.top(), path) == content_of(after.top(), [&] {
        OutlinePath above(path.begin(), path.end() - 1);
        above.emplace_back(std::string());  // nothing: only what holds nothing above is left out
        return above;
      }());
  if (!done || (!owner.empty() && !take_away_uses(after, owner)))
    return refused(fmt::format("`{}` cannot be removed as it is written", name), kByHand);
  return made(fmt::format("Remove `{}`", owner.empty() ? name : key_at(written_path, 1)), text,
              after);
}

Change connect_ports(std::string_view text, const std::string& from, const std::string& to,
                     const std::vector<KeyValue>& keys) {
  constexpr std::size_t kLongest = 1000;
  for (const std::string* const port : {&from, &to}) {
    if (port->find('.') == std::string::npos || port->size() > kLongest)
      return refused(fmt::format("`{}` is not a port", *port), "a port is `name.port`");
  }
  if (std::string problem = problem_of(keys); !problem.empty()) return refused(problem);
  std::vector<KeyValue> all = {{"from", yaml_text(from)}, {"to", yaml_text(to)}};
  all.insert(all.end(), keys.begin(), keys.end());
  const Written before(text);
  Written after = before;
  const std::string item = "{" + flow_of(all) + "}";
  if (before.top().find("connections") == nullptr && !insert_key(after, {}, "connections", "[]"))
    return refused("`connections` cannot be added as the file is written", kByHand);
  const OutlinePath list{"connections"};
  if (after.node(list) == nullptr)
    return refused("`connections` cannot be added as the file is written", kByHand);
  const std::size_t count = after.node(list)->entries.size();
  const OutlinePath place{"connections", count};
  if (!insert_item(after, list, item, lines_of_item(all), true) || after.node(place) == nullptr ||
      !differs_only_at(before, after, place) || !choose_port(after, from, true) ||
      !choose_port(after, to, false))
    return refused("a connection cannot be added as `connections` is written", kByHand);
  return made(fmt::format("Connect `{}` to `{}`", from, to), text, after);
}

}  // namespace eagerx::gen
