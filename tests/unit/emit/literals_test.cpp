#include "generator/backend/emit/literals.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>

#include "generator/backend/emit/namer.hpp"
#include "generator/frontend/spec/format.hpp"
#include "generator/support/quote/quote.hpp"

namespace eagerx::gen {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Literals, OfFloatingTypesGiveTheSameBitsBack) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 20'000; ++i) {
    const double value = std::bit_cast<double>(random());
    if (!std::isfinite(value)) continue;
    const std::string text = double_literal(value);
    ASSERT_NE(text.find_first_of(".en"), std::string::npos) << text << " would be an integer";
    ASSERT_EQ(std::bit_cast<std::uint64_t>(std::strtod(text.c_str(), nullptr)),
              std::bit_cast<std::uint64_t>(value))
        << text;
    const auto single = static_cast<float>(value);
    if (!std::isfinite(single)) continue;
    const std::string short_text = literal(value, Dtype::float32);
    ASSERT_TRUE(short_text.ends_with('F')) << short_text;
    ASSERT_EQ(std::bit_cast<std::uint32_t>(std::strtof(short_text.c_str(), nullptr)),
              std::bit_cast<std::uint32_t>(single))
        << short_text;
  }
}

TEST(Literals, OfSpecialValues) {
  EXPECT_EQ(double_literal(0.0), "0.0");
  EXPECT_EQ(double_literal(-0.0), "-0.0");
  EXPECT_EQ(double_literal(1e-8), "1e-08");
  EXPECT_EQ(double_literal(kInfinity), "std::numeric_limits<double>::infinity()");
  EXPECT_EQ(double_literal(-kInfinity), "-std::numeric_limits<double>::infinity()");
  EXPECT_EQ(double_literal(std::nan("")), "std::numeric_limits<double>::quiet_NaN()");
  EXPECT_EQ(literal(std::numeric_limits<float>::max(), Dtype::float32),
            "std::numeric_limits<float>::max()");
  EXPECT_EQ(literal(std::numeric_limits<double>::lowest(), Dtype::float64),
            "std::numeric_limits<double>::lowest()");
  EXPECT_EQ(literal(1e300, Dtype::float32), "std::numeric_limits<float>::infinity()");
}

TEST(Literals, OfIntegersStayInTheirType) {
  EXPECT_EQ(literal(-128, Dtype::int8), "std::numeric_limits<std::int8_t>::lowest()");
  EXPECT_EQ(literal(-127, Dtype::int8), "-127");
  EXPECT_EQ(literal(255, Dtype::uint8), "std::numeric_limits<std::uint8_t>::max()");
  EXPECT_EQ(literal(3, Dtype::uint32), "3U");
  EXPECT_EQ(literal(lowest_of(Dtype::int64), Dtype::int64),
            "std::numeric_limits<std::int64_t>::lowest()");
  EXPECT_EQ(literal(highest_of(Dtype::uint64), Dtype::uint64),
            "std::numeric_limits<std::uint64_t>::max()");
  EXPECT_EQ(literal(1, Dtype::boolean), "true");
  EXPECT_EQ(literal(0, Dtype::boolean), "false");
}

TEST(Literals, OfMessages) {
  const Space scalar{Dtype::float32, {}, {}, {}};
  const Space matrix{Dtype::float32, {2, 2}, {}, {}};
  const Space image{Dtype::uint8, {480, 480}, {}, {}};
  EXPECT_EQ(message_type(scalar), "float");
  EXPECT_EQ(message_type(matrix), "eagerx::Array<float, 2, 2>");
  EXPECT_EQ(message_literal({1.0}, scalar), "1.0F");
  EXPECT_EQ(message_literal({1.0}, matrix), "{{1.0F, 1.0F, 1.0F, 1.0F}}");
  EXPECT_EQ(message_literal({1, 2, 3, 4}, matrix), "{{1.0F, 2.0F, 3.0F, 4.0F}}");
  EXPECT_EQ(message_literal({7}, image),
            "eagerx::filled<eagerx::Array<std::uint8_t, 480, 480>>(7)");
}

TEST(Literals, OfTextsCannotEndTheLiteral) {
  EXPECT_EQ(cpp_string("plain"), "\"plain\"");
  EXPECT_EQ(cpp_string("a\"b\\"), "\"a\\\"b\\\\\"");
  EXPECT_EQ(cpp_string("line\nend\t"), "\"line\\012end\\011\"");
  EXPECT_EQ(cpp_string("θ"), "\"θ\"");
}

}  // namespace
}  // namespace eagerx::gen
