#include "generator/policy/formats/tensors/numbers.hpp"

#include <algorithm>
#include <charconv>
#include <string>

namespace eagerx::gen {

std::optional<std::vector<double>> numbers_in(std::string_view text) {
  std::vector<double> values;
  std::size_t at = 0;
  constexpr std::string_view kBetween = "[]() ,\n\t";
  while ((at = text.find_first_not_of(kBetween, at)) != std::string_view::npos) {
    const std::size_t end = std::min(text.find_first_of(kBetween, at), text.size());
    double value = 0.0;
    const auto result = std::from_chars(text.data() + at, text.data() + end, value);
    if (result.ec != std::errc{}) return std::nullopt;
    // NumPy writes "2." for 2.0, of which from_chars takes all.
    if (result.ptr != text.data() + end) return std::nullopt;
    values.push_back(value);
    at = end;
  }
  return values;
}

std::optional<std::vector<double>> numbers_of(const Json* value) {
  if (const auto number = number_of(value)) return std::vector<double>{*number};
  if (value == nullptr) return std::nullopt;
  if (const auto* text = value->as<std::string>()) return numbers_in(*text);
  const auto* list = value->as<Json::List>();
  if (list == nullptr) return std::nullopt;
  std::vector<double> values;
  for (const Json& item : *list) {
    const auto number = number_of(&item);
    if (!number) return std::nullopt;
    values.push_back(*number);
  }
  return values;
}

}  // namespace eagerx::gen
