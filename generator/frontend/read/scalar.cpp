#include "generator/frontend/read/scalar.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <numbers>
#include <system_error>

namespace eagerx::gen {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Takes the digits at the front of `text` away and returns how many there were.
std::size_t take_digits(std::string_view& text) {
  const auto end = std::find_if_not(text.begin(), text.end(), is_digit);
  const auto count = static_cast<std::size_t>(end - text.begin());
  text.remove_prefix(count);
  return count;
}

std::string_view without_sign(std::string_view text) {
  if (!text.empty() && (text.front() == '+' || text.front() == '-')) text.remove_prefix(1);
  return text;
}

bool has_leading_zero(std::string_view digits) {
  return digits.size() > 1 && digits[0] == '0' && is_digit(digits[1]);
}

/// `text` without sign: digits with an optional point and exponent.
bool is_decimal(std::string_view text) {
  if (has_leading_zero(text)) return false;
  const std::size_t whole = take_digits(text);
  std::size_t fraction = 0;
  if (!text.empty() && text.front() == '.') {
    text.remove_prefix(1);
    fraction = take_digits(text);
  }
  if (whole + fraction == 0) return false;
  if (text.empty()) return true;
  if (text.front() != 'e' && text.front() != 'E') return false;
  text = without_sign(text.substr(1));
  return take_digits(text) > 0 && text.empty();
}

template <class T>
std::optional<T> convert(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);  // from_chars knows no plus
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// "pi" with a decimal and `*` before it, and `/` and a decimal behind it; either may be missing.
std::optional<double> multiple_of_pi(std::string_view text) {
  const std::size_t at = text.find("pi");
  if (at == std::string_view::npos) return std::nullopt;
  std::string_view before = trimmed(text.substr(0, at));
  std::string_view after = trimmed(text.substr(at + 2));
  double value = std::numbers::pi;
  if (!before.empty() && before != "+" && before != "-") {
    if (before.back() != '*') return std::nullopt;
    before = trimmed(before.substr(0, before.size() - 1));
    const auto factor = is_decimal(without_sign(before)) ? convert<double>(before) : std::nullopt;
    if (!factor) return std::nullopt;
    value *= *factor;
  } else if (before == "-") {
    value = -value;
  }
  if (after.empty()) return value;
  after = after.front() == '/' ? trimmed(after.substr(1)) : std::string_view();
  const auto divisor = is_decimal(after) ? convert<double>(after) : std::nullopt;
  return divisor && *divisor > 0.0 ? std::optional(value / *divisor) : std::nullopt;
}

}  // namespace

std::optional<std::int64_t> parse_int(std::string_view text) {
  std::string_view digits = without_sign(text);
  if (has_leading_zero(digits) || take_digits(digits) == 0 || !digits.empty()) return std::nullopt;
  return convert<std::int64_t>(text);
}

std::optional<std::int64_t> parse_whole(std::string_view text) {
  constexpr int kHexadecimal = 16;
  if (!text.starts_with("0x")) return parse_int(text);
  std::int64_t value = 0;
  const auto [end, error] =
      std::from_chars(text.data() + 2, text.data() + text.size(), value, kHexadecimal);
  // from_chars takes a sign here, which a hexadecimal number has not.
  const bool right = error == std::errc() && end == text.data() + text.size() && text[2] != '-';
  return right ? std::optional(value) : std::nullopt;
}

std::optional<double> parse_number(std::string_view text) {
  const std::string_view unsigned_text = without_sign(text);
  if (unsigned_text == ".inf" || unsigned_text == ".Inf" || unsigned_text == ".INF") {
    const double infinity = std::numeric_limits<double>::infinity();
    return text.front() == '-' ? -infinity : infinity;
  }
  if (text == ".nan" || text == ".NaN" || text == ".NAN") {
    return std::numeric_limits<double>::quiet_NaN();
  }
  if (!is_decimal(unsigned_text)) return multiple_of_pi(text);
  return convert<double>(text);
}

bool is_decimal_text(std::string_view text) {
  return is_decimal(without_sign(text));
}

std::optional<bool> parse_bool(std::string_view text) {
  if (text == "true") return true;
  if (text == "false") return false;
  return std::nullopt;
}

bool is_null_text(std::string_view text) {
  return text.empty() || text == "~" || text == "null" || text == "Null" || text == "NULL";
}

std::string_view trimmed(std::string_view text, std::string_view blanks) {
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  return text.substr(0, text.find_last_not_of(blanks) + 1);
}

}  // namespace eagerx::gen
