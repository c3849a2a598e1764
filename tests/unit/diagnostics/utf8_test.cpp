#include "generator/support/diagnostics/utf8.hpp"

#include <gtest/gtest.h>

#include <string>

namespace eagerx::gen {
namespace {

TEST(Utf8, DecodesEveryCodePoint) {
  for (char32_t value = 0; value <= 0x10ffff; ++value) {
    if (value >= 0xd800 && value <= 0xdfff) continue;
    std::string text;
    const auto add = [&text](char32_t byte) { text += static_cast<char>(byte); };
    if (value < 0x80) {
      add(value);
    } else if (value < 0x800) {
      add(0xc0 | (value >> 6U));
      add(0x80 | (value & 0x3fU));
    } else if (value < 0x10000) {
      add(0xe0 | (value >> 12U));
      add(0x80 | ((value >> 6U) & 0x3fU));
      add(0x80 | (value & 0x3fU));
    } else {
      add(0xf0 | (value >> 18U));
      add(0x80 | ((value >> 12U) & 0x3fU));
      add(0x80 | ((value >> 6U) & 0x3fU));
      add(0x80 | (value & 0x3fU));
    }
    const CodePoint point = decode_utf8(text, 0);
    ASSERT_TRUE(point.valid) << static_cast<std::uint32_t>(value);
    ASSERT_EQ(point.value, value);
    ASSERT_EQ(point.size, text.size());
    if (text.size() == 1) continue;
    ASSERT_FALSE(decode_utf8(text.substr(0, text.size() - 1), 0).valid);  // cut short
  }
}

TEST(Utf8, RefusesMalformedBytes) {
  // Overlong, surrogate, past the end of Unicode, lone continuation, lead bytes that never occur.
  for (const char* text :
       {"\xc0\x80", "\xc1\xbf", "\xe0\x9f\xbf", "\xf0\x8f\xbf\xbf", "\xed\xa0\x80",
        "\xf4\x90\x80\x80", "\x80", "\xf5\x80\x80\x80", "\xff", "\xc3("}) {
    const CodePoint point = decode_utf8(text, 0);
    EXPECT_FALSE(point.valid) << escape_unprintable(text);
    EXPECT_EQ(point.size, 1U);
  }
}

TEST(Utf8, Counts) {
  EXPECT_EQ(count_code_points(""), 0U);
  EXPECT_EQ(count_code_points("aä漢😀"), 4U);
  EXPECT_EQ(count_code_points("a\xff\xffz"), 4U);
}

TEST(Utf8, Widths) {
  EXPECT_EQ(display_width(U'a'), 1U);
  EXPECT_EQ(display_width(U'漢'), 2U);
  EXPECT_EQ(display_width(U'😀'), 2U);
  EXPECT_EQ(display_width(U'\u0301'), 0U);
}

TEST(Utf8, Escapes) {
  EXPECT_EQ(escape_unprintable("aä\t\n\x1b\x7f\xff"), "aä\\t\\n\\x1b\\x7f\\xff");
  EXPECT_EQ(escape_unprintable("\xe2\x80\xae"), "\\u202e");
}

}  // namespace
}  // namespace eagerx::gen
