// Numbers as text that reads back to the same bits in any locale.
#pragma once

#include <array>
#include <charconv>
#include <string>
#include <string_view>

namespace eagerx::host {

/// The shortest text that reads back to the same bits.
template <class T>
std::string number_text(T value) {
  constexpr std::size_t kLongest = 32;  // -2.2250738585072014e-308 has 24
  std::array<char, kLongest> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

/// Parses all of `text` as a number of this type into `value`; false leaves it unchanged. "inf" and
/// "nan" are valid for floating-point types.
template <class T>
bool read_number(std::string_view text, T& value) {
  T read{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), read);
  if (error != std::errc{} || end != text.data() + text.size()) return false;
  value = read;
  return true;
}

/// Parses all of `text` as a number from `low` to `high` into `value`; false leaves it unchanged.
template <class T>
bool read_number(std::string_view text, T low, T high, T& value) {
  T read{};
  if (!read_number(text, read) || !(read >= low && read <= high)) return false;
  value = read;
  return true;
}

/// The double with the same decimal as the float32, 0.05 for 0.05F, so that it equals a value with
/// the same digits on a command line or in a graph. A delay of exactly 0.05F would be longer than
/// 0.05 s.
inline double same_decimal(float x) {
  double result = x;
  static_cast<void>(read_number(number_text(x), result));
  return result;
}

}  // namespace eagerx::host
