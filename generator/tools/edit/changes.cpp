#include "generator/tools/edit/changes.hpp"

#include <fmt/format.h>

#include <utility>

#include "generator/support/diagnostics/search.hpp"
#include "generator/support/quote/quote.hpp"

namespace eagerx::gen {

Change refused(std::string problem, std::string help) {
  return {std::nullopt, std::move(problem), std::move(help)};
}
Change made(std::string reason, std::string_view before, const Written& after) {
  return {difference(std::move(reason), before, after.whole())};
}

std::string shown(const OutlinePath& path) {
  std::string text;
  for (const auto& step : path) {
    if (const auto* const key = std::get_if<std::string>(&step)) {
      text += (text.empty() ? "" : ".") + *key;
    } else {
      text += fmt::format("[{}]", std::get<std::size_t>(step));
    }
  }
  return text;
}

std::string key_at(const OutlinePath& path, std::size_t index) {
  if (index >= path.size()) return {};
  const auto* const key = std::get_if<std::string>(&path[index]);
  return key != nullptr ? *key : std::string();
}

std::string problem_of(const std::vector<KeyValue>& values) {
  for (const KeyValue& each : values) {
    if (each.key.empty() || each.key.size() > 200) return "a key has no name";
    if (!is_one_value(each.value))
      return fmt::format("`{}` of `{}` is not one value of YAML", each.value, each.key);
  }
  return {};
}

std::string flow_of(const std::vector<KeyValue>& values) {
  std::string text;
  for (const KeyValue& each : values)
    text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", yaml_text(each.key), each.value);
  return text;
}

bool differs_only_at(const Written& before, const Written& after, const OutlinePath& path) {
  return content_of(before.top(), path) == content_of(after.top(), path);
}

bool has_name(const Written& written, const std::string& section, const std::string& name) {
  const OutlineNode* const all = written.top().find(section);
  return all != nullptr && ranges::any_of(all->entries, [&](const OutlineEntry& entry) {
           return entry.key == name || entry.value.text == name;
         });
}

bool is_name(const std::string& name) {
  const auto is_letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  };
  return !name.empty() && is_letter(name.front()) &&
         ranges::all_of(name, [&](char c) { return is_letter(c) || (c >= '0' && c <= '9'); });
}

bool is_taken(const Written& written, const std::string& section, const std::string& name) {
  if (is_among(kAgentSections, section)) return has_name(written, section, name);
  return ranges::any_of(kEntitySections,
                        [&](const char* each) { return has_name(written, each, name); });
}

bool add_name(Written& written, const OutlinePath& path, const std::string& name) {
  if (written.node(path) == nullptr)
    return insert_key(written, {}, key_at(path, 0), "[" + name + "]");
  const OutlineNode& node = *written.node(path);
  if (node.kind == OutlineNode::Kind::map && !node.entries.empty())
    return insert_key(written, path, name, "{}");
  return insert_item(written, path, name, {}, false);
}

}  // namespace eagerx::gen
