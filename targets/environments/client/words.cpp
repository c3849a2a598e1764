#include "targets/environments/client/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace eagerx::client {

std::string minutes(double seconds) {
  const auto whole = static_cast<long>(std::ceil(seconds));
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

std::string rounded(double number) {
  const double power =
      std::pow(10.0, std::max(0.0, std::floor(std::log10(std::max(number, 1.0))) - 2.0));
  std::string digits = fmt::format("{:.0f}", std::round(number / power) * power);
  for (std::size_t at = digits.size(); at > 3;) digits.insert(at -= 3, ",");
  return digits;
}

std::vector<std::string_view> pieces_of(std::string_view text, char separator) {
  std::vector<std::string_view> pieces;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(separator, at), text.size());
    pieces.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return pieces;
}

}  // namespace eagerx::client
