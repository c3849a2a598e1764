#include "generator/frontend/library/manifest_values.hpp"

#include <fmt/format.h>

#include <cctype>

#include "generator/frontend/spec/format.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

bool is_cpp_name(std::string_view text) {
  const auto in_name = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
  return !text.empty() && std::isdigit(static_cast<unsigned char>(text.front())) == 0 &&
         ranges::all_of(text, in_name);
}

}  // namespace

std::string text_at(const YamlValue& yaml, const char* key) {
  const YamlValue* value = yaml.find(key);
  return value != nullptr ? value->text : std::string();
}

std::vector<std::string> texts_at(const YamlValue& yaml, const char* key) {
  std::vector<std::string> result;
  if (const YamlValue* list = yaml.find(key)) {
    for (const auto& item : list->items) result.push_back(item.text);
  }
  return result;
}

void check_class(const YamlValue& name, Diagnostics& diagnostics) {
  std::string_view rest = name.text;
  if (rest.starts_with("::")) rest.remove_prefix(2);
  bool good = true;
  for (bool more = true; more && good;) {
    const std::size_t end = rest.find("::");
    more = end != std::string_view::npos;
    good = is_cpp_name(rest.substr(0, end));
    if (more) rest.remove_prefix(end + 2);
  }
  if (good && name.text.size() <= kLongestPath) return;
  diagnostics
      .error("E0205", name.span, fmt::format("{} is not the name of a C++ class", describe(name)))
      .help = "write it with its namespaces: `mine::Gain`";
}

}  // namespace eagerx::gen
