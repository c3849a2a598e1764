// UTF-8 without the C library.
#pragma once

#include <cstddef>
#include <string_view>

namespace eagerx::host {

/// One code point taken from a text. Malformed bytes come out one at a time, as U+FFFD, not valid.
struct CodePoint {
  char32_t value = 0;
  std::size_t size = 1;  // bytes
  bool valid = true;
};

/// The code point that starts at byte `at` (at < text.size()). Strict: no overlong forms, no
/// surrogates, nothing past U+10FFFF (Unicode 15, table 3-7).
CodePoint decode_utf8(std::string_view text, std::size_t at);

}  // namespace eagerx::host
