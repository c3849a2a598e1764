// Scale, Offset, Clip, Reshape, ToScalar, ToVector.
#include <gtest/gtest.h>

#include <cmath>
#include <models/processors/clip/clip.hpp>
#include <models/processors/offset/offset.hpp>
#include <models/processors/reshape/reshape.hpp>
#include <models/processors/scale/scale.hpp>
#include <models/processors/to_scalar/to_scalar.hpp>
#include <models/processors/to_vector/to_vector.hpp>

#include "tests/unit/models/block_harness.hpp"

namespace eagerx::models::testing::blocks {
namespace {

template <template <class> class Processor, class Real, class Message>
Message convert(const Message& message) {
  return Processor<ConversionIo<Real, Message>>::convert(message);
}

TEST(Scale, ComputesInReal) {
  using F = V<float, 2>;
  EXPECT_EQ((convert<Scale, float>(F{{3.0F, 3.0F}})), (F{{6.0F, 3.0F * -0.1F}}));
  EXPECT_EQ((convert<Scale, double>(F{{3.0F, 3.0F}})), (F{{6.0F, static_cast<float>(3.0 * -0.1)}}));
  EXPECT_TRUE(std::isnan((convert<Scale, double>(F{{kNan<float>, 0.0F}}))[0]));
}
TEST(Offset, Adds) {
  using D = V<double, 2>;
  EXPECT_EQ((convert<Offset, double>(D{{3.0, -3.0}})), (D{{3.0 + 0.1, -3.0 + 0.1}}));
  EXPECT_EQ((convert<Offset, float>(0.5F)), 0.5F + 0.1F);
  EXPECT_TRUE(std::isnan((convert<Offset, double>(D{{kNan<double>, 0.0}}))[0]));
}
TEST(Clip, MovesIntoLimits) {
  using F = V<float, 2>;
  EXPECT_EQ((convert<Clip, float>(F{{3.0F, 3.0F}})), (F{{0.5F, 2.0F}}));
  EXPECT_EQ((convert<Clip, float>(F{{-3.0F, 1.25F}})), (F{{-1.0F, 1.25F}}));
  EXPECT_TRUE(std::isnan((convert<Clip, float>(F{{0.0F, kNan<float>}}))[1]));
}
TEST(Shapes, KeepTheElements) {
  using Flat = Array<std::int32_t, 6>;
  using Matrix = Array<std::int32_t, 2, 3>;
  const Flat flat{{1, 2, 3, 4, 5, 6}};
  const auto matrix = Reshape<ConversionIo<float, Flat, Matrix>>::convert(flat);
  EXPECT_EQ(matrix, (Matrix{{1, 2, 3, 4, 5, 6}}));
  EXPECT_EQ((ToVector<ConversionIo<float, Matrix, Flat>>::convert(matrix)), flat);
  EXPECT_EQ((ToVector<ConversionIo<float, float, V<float>>>::convert(2.5F)), (V<float>{{2.5F}}));
  EXPECT_EQ((ToScalar<ConversionIo<float, V<float>, float>>::convert({{2.5F}})), 2.5F);
}
TEST(Processors, ConvertLanes) {
  using P = Simd<float, 4>;
  V<P, 2> message{{P(3.0F), P(-3.0F)}};
  set_lane(message[0], 1, kNan<float>);
  const auto scaled = convert<Scale, P>(message);
  const auto moved = convert<Offset, P>(message);
  const auto clipped = convert<Clip, P>(message);
  EXPECT_EQ(lane(scaled[0], 0), 6.0F);
  EXPECT_TRUE(std::isnan(lane(scaled[0], 1)));
  EXPECT_EQ(lane(moved[1], 2), -3.0F + 0.1F);
  EXPECT_EQ(lane(clipped[0], 3), 0.5F);
  EXPECT_TRUE(std::isnan(lane(clipped[0], 1)));
  EXPECT_EQ(lane(clipped[1], 1), -1.0F);
}

}  // namespace
}  // namespace eagerx::models::testing::blocks
