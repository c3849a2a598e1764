#include "generator/frontend/read/bytes.hpp"

#include <gtest/gtest.h>

namespace eagerx::gen {
namespace {

TEST(Bytes, AreReadAsDataSheetsAndLinkersWriteThem) {
  for (const char* text : {"65536", "0x10000", "64k", "64K", "64 kB", "64KB", "64 KiB", "0.0625M"})
    EXPECT_EQ(parse_bytes(text), 65536U) << text;
  EXPECT_EQ(parse_bytes("1.5 MB"), 1'572'864U);
  EXPECT_EQ(parse_bytes("2 MiB"), 2'097'152U);
  EXPECT_EQ(parse_bytes("0x40B"), 0x40bU) << "a digit, no unit";
  EXPECT_EQ(parse_bytes("12 B"), 12U);
  EXPECT_EQ(parse_bytes("0"), 0U);
}

TEST(Bytes, OtherTextsAreNone) {
  for (const char* text : {"", "k", "64 kb", "64 Kib", "64 mB", "64 G", "-1", "-1k", "0.1k", "1.5",
                           "64k ", "6 4k", ".inf", "FILL_IN", "99999999999999999M"})
    EXPECT_EQ(parse_bytes(text), std::nullopt) << text;
}

TEST(Bytes, SayWhatWasMeant) {
  EXPECT_EQ(with_right_unit_of_memory("64 kb"), "64 kB");
  EXPECT_EQ(with_right_unit_of_memory("64 kib"), "64 KiB");
  EXPECT_EQ(with_right_unit_of_memory("1 m"), "1 M");
  EXPECT_EQ(with_right_unit_of_memory("1 parsec"), "");
  EXPECT_EQ(with_right_unit_of_memory("much"), "");
}

}  // namespace
}  // namespace eagerx::gen
