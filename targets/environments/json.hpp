// JSON text, piece by piece.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace eagerx::environments {

/// Writes what it is told to; the caller opens and closes. Commas come by themselves.
class Json {
 public:
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

  const std::string& str() const { return text_; }

 private:
  Json& raw(std::string_view value);

  std::string text_;
  bool wants_comma_ = false;
};

/// The shortest text that reads back to the same bits.
std::string number_text(float value);

/// FNV-1a, 64 bits, as "0x0123456789abcdef".
std::string hash_of(std::string_view text);

}  // namespace eagerx::environments
