#include <cmath>
#include <runtime/host/base/json.hpp>
#include <runtime/host/base/number.hpp>

namespace eagerx::host {

void append_json_string(std::string& to, std::string_view text) {
  constexpr unsigned char kSpace = 0x20;
  constexpr unsigned kLowHalf = 0xf, kHalf = 4;
  to += '"';
  for (const char each : text) {
    const auto byte = static_cast<unsigned char>(each);
    if (byte < kSpace) {
      to += "\\u00";
      to += "0123456789abcdef"[byte >> kHalf];
      to += "0123456789abcdef"[byte & kLowHalf];
      continue;
    }
    if (each == '"' || each == '\\') to += '\\';
    to += each;
  }
  to += '"';
}

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
  text(name).text_ += is_compact_ ? ":" : ": ";
  wants_comma_ = false;
  return *this;
}

Json& Json::text(std::string_view value) {
  raw({});
  append_json_string(text_, value);
  return *this;
}
Json& Json::number(double value) {
  return std::isfinite(value) ? raw(number_text(value)) : null();
}
Json& Json::number(float value) {
  return std::isfinite(value) ? raw(number_text(value)) : null();
}
Json& Json::whole(std::uint64_t value) {
  return raw(number_text(value));
}
Json& Json::boolean(bool value) {
  return raw(value ? "true" : "false");
}
Json& Json::null() {
  return raw("null");
}

Json& Json::written(std::string_view json) {
  return json.empty() ? *this : raw(json);
}

Json& Json::raw(std::string_view value) {
  if (wants_comma_) text_ += is_compact_ ? "," : ", ";
  text_ += value;
  wants_comma_ = true;
  return *this;
}

}  // namespace eagerx::host
