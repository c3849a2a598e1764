#include <array>
#include <charconv>
#include <cmath>
#include <targets/environments/json.hpp>

namespace eagerx::environments {
namespace {

std::string quoted(std::string_view text) {
  constexpr unsigned char kFirstPrintable = 0x20;
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (static_cast<unsigned char>(c) < kFirstPrintable) {
      constexpr std::string_view kDigits = "0123456789abcdef";
      result += "\\u00";
      result += kDigits[static_cast<unsigned char>(c) >> 4U];
      result += kDigits[static_cast<unsigned char>(c) & 0xfU];
    } else {
      result += c;
    }
  }
  return result + "\"";
}

template <class T>
std::string shortest_text(T value) {
  constexpr std::size_t kLongestNumber = 32;  // -2.2250738585072014e-308 has 24
  std::array<char, kLongestNumber> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

}  // namespace

Json& Json::begin_object() {
  raw("{");
  wants_comma_ = false;
  return *this;
}
Json& Json::end_object() {
  text_ += "}";
  wants_comma_ = true;
  return *this;
}
Json& Json::begin_list() {
  raw("[");
  wants_comma_ = false;
  return *this;
}
Json& Json::end_list() {
  text_ += "]";
  wants_comma_ = true;
  return *this;
}
Json& Json::key(std::string_view name) {
  raw(quoted(name)).text_ += ": ";
  wants_comma_ = false;
  return *this;
}

Json& Json::text(std::string_view value) {
  return raw(quoted(value));
}
Json& Json::number(double value) {
  return std::isfinite(value) ? raw(shortest_text(value)) : null();
}
Json& Json::number(float value) {
  return std::isfinite(value) ? raw(shortest_text(value)) : null();
}
Json& Json::whole(std::uint64_t value) {
  return raw(std::to_string(value));
}
Json& Json::boolean(bool value) {
  return raw(value ? "true" : "false");
}
Json& Json::null() {
  return raw("null");
}

Json& Json::raw(std::string_view value) {
  if (wants_comma_) text_ += ", ";
  text_ += value;
  wants_comma_ = true;
  return *this;
}

std::string number_text(float value) {
  return shortest_text(value);
}

std::string hash_of(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  std::string result = "0x";
  for (unsigned shift = 64; shift > 0;) {
    shift -= 4;
    result += "0123456789abcdef"[(hash >> shift) & 0xfU];
  }
  return result;
}

}  // namespace eagerx::environments
