#include "generator/import/written.hpp"

#include <fmt/format.h>

#include <vector>

#include "generator/quote/quote.hpp"

namespace eagerx::gen {
std::string in_braces(const std::vector<std::string>& items) {
  return fmt::format("{{{}}}", fmt::join(items, ", "));
}

std::string text_of(const YamlValue& yaml) {
  std::vector<std::string> items;
  switch (yaml.kind) {
    case YamlKind::null:
      return "null";
    case YamlKind::scalar:
      return yaml.quoted ? yaml_string(yaml.text) : yaml_scalar(yaml.text);
    case YamlKind::sequence:
      for (const auto& item : yaml.items) items.push_back(text_of(item));
      return fmt::format("[{}]", fmt::join(items, ", "));
    case YamlKind::map:
      for (const auto& entry : yaml.entries) {
        items.push_back(fmt::format("{}: {}", yaml_scalar(entry.key), text_of(entry.value)));
      }
      return in_braces(items);
  }
  return "null";
}

std::string space_text(const SpaceSpec& space) {
  std::vector<std::string> items;
  if (space.dtype) items.push_back("dtype: " + yaml_scalar(space.dtype->value));
  if (space.shape) items.push_back("shape: " + text_of(*space.shape));
  if (space.low) items.push_back("low: " + text_of(*space.low));
  if (space.high) items.push_back("high: " + text_of(*space.high));
  return in_braces(items);
}

}  // namespace eagerx::gen
