#include "generator/tools/edit/structure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "generator/frontend/read/tree.hpp"
#include "generator/support/quote/quote.hpp"
#include "generator/tools/edit/changes.hpp"
#include "generator/tools/edit/words.hpp"

namespace eagerx::gen {
namespace {

using Kind = OutlineNode::Kind;

/// The keys of an object or node on lines, where its siblings have theirs on such.
bool has_entries_on_lines(const Written& written, const std::string& section) {
  const OutlineNode* const all = written.top().find(section);
  if (all == nullptr || all->flow || all->entries.empty()) return false;
  const OutlineNode& last = all->entries.back().value;
  return last.kind == Kind::map && !last.flow;
}

/// Adds `name: …` to a section with the keys in braces, or each on a line.
bool add_to_section(Written& written, const NewEntry& entry, const std::vector<KeyValue>& keys) {
  const bool on_lines = has_entries_on_lines(written, entry.section);
  if (written.top().find(entry.section) == nullptr) {
    // With what is in it, so that no section is empty in between.
    if (!insert_key(written, {}, entry.section, "{}")) return false;
  }
  const std::string value = "{" + flow_of(keys) + "}";
  if (!insert_key(written, {entry.section}, entry.name, value)) return false;
  if (!on_lines || keys.empty()) return true;
  // It is in braces yet, at the end of a line of its own.
  const OutlineEntry* const added = written.entry({entry.section, entry.name});
  if (added == nullptr) return false;
  const std::size_t begin = written.value_begin(*added), end = written.end_of(*added);
  const std::string indent(written.column(added->whole.begin) + written.step(), ' ');
  std::string lines;
  for (const KeyValue& each : keys)
    lines += fmt::format("{}{}{}: {}", written.newline(), indent, yaml_text(each.key), each.value);
  written.replace({begin, end}, lines);
  return true;
}

}  // namespace

bool is_one_value(const std::string& value) {
  constexpr std::size_t kMostBytes = 100'000;
  if (value.empty() || value.size() > kMostBytes) return false;
  if (value.find_first_of("\r\n") != std::string::npos) return false;
  if (value.front() == '&' || value.front() == '!') return false;  // which would name it
  SourceMap sources;
  Diagnostics problems;
  const YamlValue tree =
      read_yaml_text("value", "{key: " + value + "}", sources, problems, Tags::refuse);
  if (problems.has_errors() || !tree.is_map() || tree.entries.size() != 1) return false;
  // And what the outline makes of it, which finds places with less of YAML.
  const OutlineNode outline = outline_of("{key: " + value + "}");
  return outline.entries.size() == 1 && outline.entries.front().key == "key" &&
         outline.entries.front().value.kind != Kind::nothing;
}

Edit difference(std::string reason, std::string_view before, std::string_view after) {
  const std::size_t shorter = std::min(before.size(), after.size());
  std::size_t begin = 0, end = 0;
  while (begin < shorter && before[begin] == after[begin]) ++begin;
  while (end < shorter - begin && before[before.size() - 1 - end] == after[after.size() - 1 - end])
    ++end;
  return {std::move(reason),
          {{{begin, before.size() - end},
            std::string(after.substr(begin, after.size() - end - begin))}}};
}

Change add_entry(std::string_view text, const NewEntry& entry) {
  const bool is_entity = is_among(kEntitySections, entry.section);
  if (!is_entity && !is_among(kAgentSections, entry.section))
    return refused(fmt::format("nothing can be added to `{}`", entry.section),
                   "available: objects, nodes, actions, observations");
  const Written before(text);
  if (!is_name(entry.name))
    return refused(fmt::format("`{}` is not a name", entry.name),
                   "a name has letters, digits and `_`, and begins with no digit");
  constexpr std::array kReserved = {"actions", "observations", "engine", "environment"};
  if (is_taken(before, entry.section, entry.name) || (is_entity && is_among(kReserved, entry.name)))
    return refused(fmt::format("there is `{}` already", entry.name), "choose another name");
  if (is_entity && !is_name(entry.type))
    return refused(fmt::format("`{}` is not an id of an entity", entry.type));
  for (const auto* const values : {&entry.keys, &entry.parameters}) {
    if (std::string problem = problem_of(*values); !problem.empty()) return refused(problem);
  }
  std::vector<KeyValue> keys;
  if (is_entity) keys.push_back({"type", entry.type});
  keys.insert(keys.end(), entry.keys.begin(), entry.keys.end());
  if (!entry.parameters.empty()) keys.push_back({"config", "{" + flow_of(entry.parameters) + "}"});

  Written after = before;
  const OutlineNode* const section = before.top().find(entry.section);
  const bool names = section == nullptr || section->kind == Kind::list ||
                     (section->flow && section->entries.empty());
  bool done = false;
  OutlinePath place{entry.section, entry.name};
  if (keys.empty() && (names || section->kind == Kind::nothing)) {
    if (section != nullptr && section->kind == Kind::map)
      done = add_to_section(after, entry, keys);
    else
      done = add_name(after, {entry.section}, entry.name);
    if (const OutlineNode* now = after.top().find(entry.section);
        now != nullptr && now->kind == Kind::list && !now->entries.empty())
      place.back() = now->entries.size() - 1;
  } else {
    const bool is_map = section == nullptr || section->kind != Kind::list ||
                        make_map_of_names(after, {entry.section});
    const std::string made_content = content_of(after.top(), {entry.section});
    done = is_map && add_to_section(after, entry, keys) &&
           content_of(after.top(), {entry.section}) == made_content;
    if (done && section != nullptr && section->kind == Kind::list) place = {entry.section};
  }
  if (!done || after.node(place) == nullptr || !differs_only_at(before, after, place))
    return refused(
        fmt::format("`{}` cannot be added to `{}` as it is written", entry.name, entry.section),
        kByHand);
  return made(fmt::format("Add `{}`", entry.name), text, after);
}

Change set_value(std::string_view text, const OutlinePath& path, const std::string& value) {
  if (path.empty()) return refused("there is no path");
  if (!is_one_value(value))
    return refused(fmt::format("`{}` is not one value of YAML", value),
                   "put a text that has another meaning in quotes");
  const Written before(text);
  Written after = before;
  const std::string name = shown(path);
  Change impossible = refused(fmt::format("`{}` cannot be set where it is written", name), kByHand);
  if (const OutlineEntry* const entry = before.entry(path)) {
    const std::size_t begin = before.value_begin(*entry);
    std::size_t end = std::max(begin, before.end_of(*entry));
    if (entry->value.kind == Kind::nothing) end = begin;
    if (before.has_comment(begin, end))
      return refused(fmt::format("`{}` has comments in it", name), "set what is in it, one by one");
    const std::size_t first = before.in(begin, end).find_first_not_of(" \t\r\n");
    if (first != std::string_view::npos &&
        std::string_view("&!").find(before.text()[begin + first]) != std::string_view::npos)
      return refused(fmt::format("`{}` has an anchor or a tag", name), kByHand);
    const bool is_item = entry->key.empty() && !before.has_dash(*entry);
    after.replace({begin, end},
                  fmt::format("{}{}{}", entry->has_colon || entry->key.empty() ? "" : ":",
                              is_item ? "" : " ", value));
  } else {
    std::size_t known = path.size() - 1;
    while (known > 0 && before.node(beginning_of(path, known)) == nullptr) --known;
    const OutlinePath above = beginning_of(path, known);
    std::string inner = value;
    for (std::size_t i = path.size() - 1; i > known; --i) {
      const std::string key = key_at(path, i);
      if (key.empty()) return impossible;
      inner = fmt::format("{{{}: {}}}", yaml_text(key), inner);
    }
    const std::string key = key_at(path, known);
    if (key.empty()) return impossible;
    const OutlineNode& last = *before.node(above);
    if (last.kind == Kind::list) {
      // `[angle]` becomes `{angle: {…}}`.
      if (!has_name(before, key_at(above, 0), key) && above.size() == 1) return impossible;
      if (!make_map_of_names(after, above)) return impossible;
      OutlinePath of_name = above;
      of_name.emplace_back(key);
      const OutlineEntry* const named = after.entry(of_name);
      if (named == nullptr) return impossible;
      after.replace({after.value_begin(*named), after.end_of(*named)}, " " + inner);
      return after.node(path) != nullptr && differs_only_at(before, after, above)
                 ? made(fmt::format("Set `{}`", name), text, after)
                 : impossible;
    }
    if (!insert_key(after, above, key, inner)) return impossible;
  }
  if (after.node(path) == nullptr || !differs_only_at(before, after, path)) return impossible;
  return made(fmt::format("Set `{}`", name), text, after);
}

}  // namespace eagerx::gen
