#include "generator/frontend/import/written.hpp"

#include <fmt/format.h>

#include <cctype>
#include <vector>

#include "generator/frontend/read/scalar.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/quote/quote.hpp"

namespace eagerx::gen {

std::string legal_name(const std::string& text) {
  if (is_identifier(text)) return text;
  std::string name;
  for (const char c : text) {
    const bool letter = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (letter || (!name.empty() && name.back() != '_')) name += letter ? c : '_';
  }
  if (name.empty() || std::isdigit(static_cast<unsigned char>(name[0])) != 0) name = "a_" + name;
  constexpr std::size_t kLongest = 80;
  name = name.substr(0, kLongest);
  if (name.back() != '_' && !is_identifier(name)) name += "_";
  return name;
}

std::string in_braces(const std::vector<std::string>& items) {
  return fmt::format("{{{}}}", join(items, ", "));
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
      return fmt::format("[{}]", join(items, ", "));
    case YamlKind::map:
      for (const auto& entry : yaml.entries) {
        items.push_back(fmt::format("{}: {}", yaml_scalar(entry.key), text_of(entry.value)));
      }
      return in_braces(items);
  }
  return "null";
}

std::optional<std::string> joined_names(const YamlValue& yaml) {
  if (!yaml.is_sequence() || yaml.items.empty()) return std::nullopt;
  std::string result;
  for (const auto& item : yaml.items) {
    if (!item.is_scalar() || item.text.empty() || parse_number(item.text) ||
        item.text.find_first_of(" \t\n") != std::string::npos)
      return std::nullopt;
    result += (result.empty() ? "" : " ") + item.text;
  }
  return result;
}

std::string space_text(const SpaceSpec& space) {
  std::vector<std::string> items;
  if (space.dtype) items.push_back("dtype: " + yaml_scalar(space.dtype->value));
  if (space.shape) items.push_back("shape: " + text_of(*space.shape));
  if (space.low) items.push_back("low: " + text_of(*space.low));
  if (space.high) items.push_back("high: " + text_of(*space.high));
  return in_braces(items);
}

std::string config_text(const std::vector<Setting>& config) {
  std::vector<std::string> items;
  items.reserve(config.size());
  for (const auto& setting : config)
    items.push_back(fmt::format("{}: {}", yaml_text(setting.name), text_of(setting.value)));
  return in_braces(items);
}

std::string processor_text(const ProcessorSpec& processor) {
  if (!processor.before.empty()) {
    std::vector<std::string> items;
    for (const ProcessorSpec& each : processor.before) items.push_back(processor_text(each));
    items.push_back(processor_text({processor.type, processor.config, {}}));
    return fmt::format("[{}]", join(items, ", "));
  }
  if (processor.config.empty()) return yaml_scalar(processor.type.value);
  return fmt::format("{{type: {}, config: {}}}", yaml_scalar(processor.type.value),
                     config_text(processor.config));
}

}  // namespace eagerx::gen
