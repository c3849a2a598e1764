#include <gtest/gtest.h>

#include <cmath>
#include <models/processors/decomposed_angle/decomposed_angle.hpp>
#include <models/processors/get_index/get_index.hpp>
#include <models/processors/identity/identity.hpp>
#include <models/processors/negate/negate.hpp>

#include "tests/unit/models/entity_io.hpp"

namespace eagerx::models::testing {
namespace {

TEST(DecomposedAngle, IsCosineAndSine) {
  using InFloat = DecomposedAngle<ProcessorIo<float, float, Array<float, 2>>>;
  using InDouble = DecomposedAngle<ProcessorIo<double, float, Array<float, 2>>>;
  for (float theta = -10.0F; theta < 10.0F; theta += 0.173F) {
    const auto exact = static_cast<double>(theta);
    for (const auto& point : {InFloat::convert(theta), InDouble::convert(theta)}) {
      EXPECT_NEAR(point[0], std::cos(exact), 1.2e-7);
      EXPECT_NEAR(point[1], std::sin(exact), 1.2e-7);
    }
  }
}

TEST(GetIndex, PicksAnElementAsAnArrayOfOne) {
  using Processor = GetIndex<ProcessorIo<float, Array<double, 2, 2>, Array<float, 1>>>;
  EXPECT_EQ(Processor::convert({{0.1, 0.2, 0.3, 0.4}}), (Array<float, 1>{{0.3F}}));
}

TEST(Negate, ChangesEverySign) {
  using Processor = Negate<ProcessorIo<float, Array<float, 3>, Array<float, 3>>>;
  EXPECT_EQ(Processor::convert({{1.0F, -2.0F, 0.5F}}), (Array<float, 3>{{-1.0F, 2.0F, -0.5F}}));
  using Integer = Negate<ProcessorIo<float, std::int8_t, std::int8_t>>;
  EXPECT_EQ(Integer::convert(5), -5);
}

TEST(Identity, ChangesNothing) {
  using Processor = Identity<ProcessorIo<float, Array<float, 2>, Array<float, 2>>>;
  EXPECT_EQ(Processor::convert({{1.0F, -2.0F}}), (Array<float, 2>{{1.0F, -2.0F}}));
}

}  // namespace
}  // namespace eagerx::models::testing
