#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <models/processors/angle_decomposition/angle_decomposition.hpp>
#include <models/processors/choose_value/choose_value.hpp>
#include <models/processors/choose_values/choose_values.hpp>
#include <models/processors/decomposed_angle/decomposed_angle.hpp>
#include <models/processors/get_index/get_index.hpp>
#include <models/processors/identity/identity.hpp>
#include <models/processors/negate/negate.hpp>
#include <models/processors/normalize_angle/normalize_angle.hpp>
#include <models/processors/obs_with_decomposed_angle/obs_with_decomposed_angle.hpp>
#include <models/processors/to_uint8/to_uint8.hpp>
#include <models/processors/voltage_to_motor_torque/voltage_to_motor_torque.hpp>

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

TEST(GetIndex, PicksElements) {
  using One = GetIndex<IndexIo<Array<double, 2, 2>, 2>>;
  EXPECT_EQ(One::convert({{0.1, 0.2, 0.3, 0.4}}), (Array<float, 1>{{0.3F}}));
  using Three = GetIndex<IndexIo<Array<double, 2, 2>, 3, 0, 3>>;
  EXPECT_EQ(Three::convert({{0.1, 0.2, 0.3, 0.4}}), (Array<float, 3>{{0.4F, 0.1F, 0.4F}}));
}

struct ThreeVoltages : ProcessorIo<float, std::int64_t, Array<float, 1>> {
  struct Config {
    static constexpr std::array<double, 3> values = {-2.0, 0.0, 2.0};
  };
};

TEST(ChooseValue, TakesTheNearestOfItsValues) {
  const auto value = [](std::int64_t k) { return ChooseValue<ThreeVoltages>::convert(k)[0]; };
  EXPECT_EQ(value(0), -2.0F);
  EXPECT_EQ(value(1), 0.0F);
  EXPECT_EQ(value(2), 2.0F);
  EXPECT_EQ(value(-5), -2.0F);
  EXPECT_EQ(value(7), 2.0F);
}

struct SeveralVoltages : ProcessorIo<float, Array<std::int32_t, 4>, Array<float, 4>> {
  using Config = ThreeVoltages::Config;
};

TEST(ChooseValues, TakesTheNearestForEach) {
  EXPECT_EQ(ChooseValues<SeveralVoltages>::convert({{0, 1, -9, 7}}),
            (Array<float, 4>{{-2.0F, 0.0F, -2.0F, 2.0F}}));
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

TEST(ToUint8, TruncatesAndLimitsNumbersAndWrapsIntegers) {
  using Processor = ToUint8<ProcessorIo<float, Array<float, 6>, Array<std::uint8_t, 6>>>;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(Processor::convert({{0.0F, 1.9F, 254.999F, 255.5F, -3.0F, nan}}),
            (Array<std::uint8_t, 6>{{0, 1, 254, 255, 0, 0}}));
  using Integer = ToUint8<ProcessorIo<float, Array<std::int64_t, 3>, Array<std::uint8_t, 3>>>;
  EXPECT_EQ(Integer::convert({{7, 256 + 3, -1}}), (Array<std::uint8_t, 3>{{7, 3, 255}}));
}

struct First : ProcessorIo<float, Array<float, 3>, Array<float, 4>> {
  struct Config {
    static constexpr int index = 0;
  };
};

TEST(AngleDecomposition, ReplacesOneElementByTwo) {
  using Processor = AngleDecomposition<ProcessorIo<double, Array<float, 3>, Array<float, 4>>>;
  const auto result = Processor::convert({{5.0F, 6.0F, 0.5F}});  // index 2
  EXPECT_EQ(result[0], 5.0F);
  EXPECT_EQ(result[1], 6.0F);
  EXPECT_EQ(result[2], static_cast<float>(std::cos(0.5)));
  EXPECT_EQ(result[3], static_cast<float>(std::sin(0.5)));
  const auto first = AngleDecomposition<First>::convert({{0.0F, 6.0F, 7.0F}});
  EXPECT_EQ(first, (Array<float, 4>{{1.0F, 0.0F, 6.0F, 7.0F}}));
}

TEST(NormalizeAngle, MovesByWholeTurns) {
  using InDouble = NormalizeAngle<ProcessorIo<double, float, float>>;
  using InFloat = NormalizeAngle<ProcessorIo<float, float, float>>;
  constexpr auto kPi = static_cast<float>(M_PI);
  for (float theta = -40.0F; theta < 40.0F; theta += 0.31F) {
    const double expected = std::remainder(static_cast<double>(theta), 2.0 * M_PI);
    EXPECT_NEAR(static_cast<double>(InDouble::convert(theta)), expected, 2.5e-7);
    EXPECT_NEAR(static_cast<double>(InFloat::convert(theta)), expected, 1e-5);
    EXPECT_LE(std::abs(InFloat::convert(theta)), kPi);
  }
  for (const float theta : {kPi, -kPi, 3 * kPi, std::nextafter(kPi, 4.0F), 1e9F}) {
    EXPECT_LE(std::abs(InFloat::convert(theta)), kPi);
    EXPECT_LE(std::abs(InDouble::convert(theta)), kPi);
  }
  EXPECT_TRUE(std::isnan(InFloat::convert(std::numeric_limits<float>::infinity())));
}

TEST(VoltageToMotorTorque, IsMinusVoltageTimesKOverR) {
  using Processor = VoltageToMotorTorque<ProcessorIo<double, Array<float, 1>, Array<float, 1>>>;
  EXPECT_EQ(Processor::convert({{2.0F}}), (Array<float, 1>{{-0.125F}}));
}

TEST(ObsWithDecomposedAngle, IsMinusTheAngleAndMinusTheSpeed) {
  using Processor = ObsWithDecomposedAngle<ProcessorIo<double, Array<float, 3>, Array<float, 2>>>;
  for (float phi = -3.1F; phi < 3.1F; phi += 0.2F) {
    const auto result = Processor::convert({{std::cos(phi), std::sin(phi), 4.0F}});
    EXPECT_NEAR(result[0], -phi, 3e-7);
    EXPECT_EQ(result[1], -4.0F);
  }
}

}  // namespace
}  // namespace eagerx::models::testing
