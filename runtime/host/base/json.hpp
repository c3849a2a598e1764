// JSON text, piece by piece.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace eagerx::host {

/// Appends foreign text as a JSON string to `to`. Invalid UTF-8 is unchanged.
void append_json_string(std::string& to, std::string_view text);

/// Writes JSON; the caller opens and closes. Commas come by themselves.
class Json {
 public:
  /// `compact`: without blanks.
  enum class Style : std::uint8_t { spaced, compact };
  explicit Json(Style style = Style::spaced) : is_compact_(style == Style::compact) {}

  Json& begin_object();
  Json& end_object();
  Json& begin_list();
  Json& end_list();
  Json& key(std::string_view name);
  Json& text(std::string_view value);
  /// Infinite and NaN: null.
  Json& number(double value);
  /// The shortest text that reads back to the same bits; infinite and NaN: null.
  Json& number(float value);
  Json& whole(std::uint64_t value);
  Json& boolean(bool value);
  Json& null();
  /// JSON text: values with commas between them, or nothing.
  Json& written(std::string_view json);

  const std::string& str() const { return text_; }

 private:
  Json& raw(std::string_view value);

  std::string text_;
  bool is_compact_ = false;
  bool wants_comma_ = false;
};

}  // namespace eagerx::host
