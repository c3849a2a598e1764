#include "generator/frontend/spec/reference.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace eagerx::gen {
namespace {

constexpr std::string_view kBegin = "$(";

}  // namespace

Reference parameter_reference(std::string name) {
  return {"config", std::move(name)};
}

Reference rate_reference(std::string section, std::string name) {
  return {std::move(section), std::move(name), "rate"};
}

std::string to_string(const Reference& reference) {
  std::string text = reference.what;
  for (const std::string* word : {&reference.name, &reference.part}) {
    if (!word->empty()) text += " " + *word;
  }
  return text;
}

std::string in_dollars(const Reference& reference) {
  return fmt::format("$({})", to_string(reference));
}

YamlValue made_reference(Reference reference, Span span) {
  YamlValue yaml = made_scalar(in_dollars(reference), span);
  yaml.reference = std::make_shared<const Reference>(std::move(reference));
  return yaml;
}

std::optional<Reference> parse_reference(std::string_view text) {
  if (!text.starts_with(kBegin) || !text.ends_with(')')) return std::nullopt;
  text = text.substr(kBegin.size(), text.size() - kBegin.size() - 1);
  if (text.find_first_of("()") != std::string_view::npos) return std::nullopt;
  std::array<std::string, 3> words;
  for (std::string& word : words) {
    const std::size_t end = text.find(' ');
    word = text.substr(0, end);
    if (word.empty()) return std::nullopt;
    if (end == std::string_view::npos) return Reference{words[0], words[1], words[2]};
    text.remove_prefix(end + 1);
  }
  return std::nullopt;
}

std::optional<Reference> reference_in(const YamlValue& yaml) {
  if (yaml.reference) return *yaml.reference;
  return yaml.is_scalar() && !yaml.quoted ? parse_reference(yaml.text) : std::nullopt;
}

bool is_expression(const YamlValue& yaml) {
  if (yaml.reference) return true;
  const std::size_t reference = yaml.text.find(kBegin);
  return yaml.is_scalar() && !yaml.quoted && reference != std::string::npos &&
         yaml.text.ends_with(')') && yaml.text.find_first_not_of("0123456789.+-*/( ") >= reference;
}

}  // namespace eagerx::gen
