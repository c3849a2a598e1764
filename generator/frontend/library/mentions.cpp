#include "generator/frontend/library/mentions.hpp"

#include <algorithm>
#include <utility>

namespace eagerx::gen {
namespace {

constexpr std::string_view kWord =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";

}  // namespace

void Mentions::add(const YamlValue& yaml) {
  add(yaml.text);
  for (const YamlValue& item : yaml.items) add(item);
  for (const auto& entry : yaml.entries) {
    add(entry.key);
    add(entry.value);
  }
}

void Mentions::add_manifest(const YamlValue& manifest) {
  for (const auto& entry : manifest.entries) {
    if (entry.key != "engines") {
      add(entry.value);
      continue;
    }
    // A list of names says where an engine node works, which brings in none of these engines.
    for (const auto& engine : entry.value.entries) {
      if (texts_.contains(engine.key))
        add(engine.value);
      else
        waiting_.emplace(engine.key, &engine.value);
    }
  }
}

std::optional<std::string> Mentions::next() {
  if (todo_.empty()) return std::nullopt;
  std::string text = std::move(todo_.back());
  todo_.pop_back();
  return text;
}

void Mentions::add(const std::string& text) {
  if (text.find('.') != std::string::npos) return;  // a port, which is no id
  if (!texts_.insert(text).second) return;
  todo_.push_back(text);
  const auto [first, last] = waiting_.equal_range(text);
  std::vector<const YamlValue*> now;
  for (auto item = first; item != last; ++item) now.push_back(item->second);
  waiting_.erase(first, last);
  for (const YamlValue* yaml : now) add(*yaml);
}

std::optional<std::string_view> declared_id(std::string_view text) {
  constexpr std::string_view kKey = "\nid:";
  std::size_t at = text.starts_with(kKey.substr(1)) ? kKey.size() - 1 : std::string_view::npos;
  if (const std::size_t line = text.find(kKey); line != std::string_view::npos) {
    const bool twice =
        at != std::string_view::npos || text.find(kKey, line + 1) != std::string_view::npos;
    if (twice) return std::nullopt;
    at = line + kKey.size();
  }
  if (at == std::string_view::npos || text.substr(at, 1) != " ") return std::nullopt;
  const std::string_view line = text.substr(at, text.find('\n', at) - at);
  const std::size_t begin = std::min(line.find_first_not_of(' '), line.size());
  const std::size_t end = std::min(line.find_first_not_of(kWord, begin), line.size());
  const std::string_view rest = line.substr(end);
  const std::size_t next = std::min(rest.find_first_not_of(' '), rest.size());
  const bool ends = next == rest.size() || (next > 0 && rest[next] == '#');
  if (end == begin || !ends) return std::nullopt;
  return line.substr(begin, end - begin);
}

}  // namespace eagerx::gen
