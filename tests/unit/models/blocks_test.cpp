// Blocks without memory, and sources, against their equations.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <models/nodes/constant/constant.hpp>
#include <models/nodes/dead_zone/dead_zone.hpp>
#include <models/nodes/demux/demux.hpp>
#include <models/nodes/difference/difference.hpp>
#include <models/nodes/gain/gain.hpp>
#include <models/nodes/lookup_table/lookup_table.hpp>
#include <models/nodes/lookup_table_2d/lookup_table_2d.hpp>
#include <models/nodes/matrix_gain/matrix_gain.hpp>
#include <models/nodes/mux/mux.hpp>
#include <models/nodes/product/product.hpp>
#include <models/nodes/quantizer/quantizer.hpp>
#include <models/nodes/reference/reference.hpp>
#include <models/nodes/saturation/saturation.hpp>
#include <models/nodes/sum/sum.hpp>
#include <models/nodes/switch/switch.hpp>
#include <models/processors/scale/scale.hpp>
#include <numbers>

#include "tests/unit/models/block_harness.hpp"

namespace eagerx::models::testing::blocks {
namespace {

using D1 = V<double>;
using D2 = V<double, 2>;

TEST(Sum, AddsWithItsGains) {
  Ticking<Sum, SumIo<double>> sum;
  EXPECT_EQ(sum(D2{{1.0, 10.0}}, D2{{0.25, 2.0}}, D2{{3.0, 8.0}}), (D2{{2.0, 10.0}}));
  EXPECT_EQ(sum.tick({nothing<D2>(), nothing<D2>(), nothing<D2>()}), D2{});
  const auto y = sum(D2{{kNan<double>, 1.0}}, D2{}, D2{});
  EXPECT_TRUE(std::isnan(y[0]));
  EXPECT_EQ(y[1], 1.0);
  expect_lanes<Sum, SumIo, 2, 2, 2>();
}

TEST(Difference, SubtractsAndTurns) {
  Ticking<Difference, DifferenceIoOf<double, DifferenceConfig>> plain;
  EXPECT_EQ(plain(D1{{1.0}}, 3.5)[0], -2.5);
  EXPECT_TRUE(std::isnan(plain(D1{{kNan<double>}}, 1.0)[0]));
  EXPECT_EQ(plain.tick({nothing<D1>(), nothing<double>()})[0], 0.0);
  Ticking<Difference, AngleIo<double>> angle;
  EXPECT_EQ(angle(D1{{0.75}}, D1{{-0.5}})[0], -0.75);
  EXPECT_EQ(angle(D1{{0.25}}, D1{{-0.5}})[0], 0.75);
  expect_lanes<Difference, AngleIo, 1, 1>();
}

TEST(Gain, IsOfEachElement) {
  Ticking<Gain, GainIo<double>> gain;
  EXPECT_EQ(gain(D2{{2.0, 4.0}}), (D2{{6.0, -2.0}}));
  EXPECT_EQ(gain.tick({nothing<D2>()}), D2{});
  EXPECT_TRUE(std::isnan(gain(D2{{1.0, kNan<double>}})[1]));
  expect_lanes<Gain, GainIo, 2>();
}

TEST(MatrixGain, IsTheMatrixTimesTheVector) {
  Ticking<MatrixGain, MatrixIo<double>> gain;
  EXPECT_EQ(gain(D2{{10.0, 1.0}}), (V<double, 3>{{12.0, 34.0, -50.0 + 0.1}}));
  EXPECT_EQ(gain.tick({nothing<D2>()}), (V<double, 3>{}));
  EXPECT_TRUE(std::isnan(gain(D2{{kNan<double>, 0.0}})[2]));
  Ticking<MatrixGain, MatrixIo<float>> in_float;
  EXPECT_FLOAT_EQ(in_float(V<float, 2>{{10.0F, 1.0F}})[2], -49.9F);
  expect_lanes<MatrixGain, MatrixIo, 2>();
}

TEST(Constant, IsItsValueOrWhatAResetSets) {
  Ticking<Constant, SourceIo<double, ConstantConfig>> constant;
  EXPECT_EQ(constant()[0], 2.5);
  Ticking<Constant, SampledConstantIo<double>> sampled;
  EXPECT_EQ(sampled()[0], 2.5);
  sampled.reset({V<float>{{-1.0F}}});
  EXPECT_EQ(sampled()[0], -1.0);
  sampled.reset();
  EXPECT_EQ(sampled()[0], -1.0) << "it is not set: it keeps its value";
}

/// The largest error over three seconds.
template <class Real, ReferenceShape Shape, class F>
double largest_error(F&& expected) {
  Ticking<Reference, SourceIo<Real, ReferenceConfig<Shape>>> reference;
  double error = 0.0;
  for (int n = 0; n < 310; ++n) {
    const double y = static_cast<double>(reference()[0]);
    const double right = n < 10 ? 0.5 : 0.5 + 2.0 * expected(static_cast<double>(n - 10) / 100.0);
    error = std::max(error, std::abs(y - right));
  }
  return error;
}
template <ReferenceShape Shape, class F>
void expect_shape(F&& expected) {
  EXPECT_LT((largest_error<double, Shape>(expected)), 1e-12);
  EXPECT_LT((largest_error<float, Shape>(expected)), 2e-5);
}
TEST(Reference, IsItsShape) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  EXPECT_EQ((largest_error<float, ReferenceShape::step>([](double) { return 1.0; })), 0.0);
  expect_shape<ReferenceShape::ramp>([](double t) { return std::min(t / 2.0, 1.0); });
  expect_shape<ReferenceShape::sine>([](double t) { return std::sin(kTurn * 1.5 * t); });
  expect_shape<ReferenceShape::chirp>([](double t) {
    const double s = std::min(t, 2.0);
    return std::sin(kTurn * (1.5 * s + 2.5 * s * s / 4.0 + 4.0 * (t - s)));
  });
}
TEST(Reference, IsScipysChirp) {
  Ticking<Reference, SourceIo<double, ReferenceConfig<ReferenceShape::chirp>>> chirp;
  for (int n = 0; n < 10; ++n) chirp();
  for (const auto& row : reference("chirp")) expect_near(chirp(), row, 0, 0.0);
}

template <class Real>
void expect_table(double in_float) {
  Ticking<Reference, SourceIo<Real, ReferenceConfig<ReferenceShape::table>>> lines;
  Ticking<Reference, SourceIo<Real, StepsOfTableConfig>> steps;
  for (int episode = 0; episode < 2; ++episode) {
    for (const auto& row : reference("reference_table")) {
      expect_near(lines(), row, 0, in_float);
      expect_near(steps(), row, 1, in_float);
    }
    lines.reset();
    steps.reset();
  }
}
TEST(Reference, IsItsTable) {
  expect_table<double>(0.0);
  expect_table<float>(2e-5);
}

TEST(Saturation, MovesIntoLimitsThatAResetMaySet) {
  Ticking<Saturation, LimitsIo<double>> plain;
  EXPECT_EQ(plain(D2{{-3.0, 1.0}}), (D2{{-1.0, 0.5}}));
  EXPECT_EQ(plain(D2{{kInf, 0.25}}), (D2{{2.0, 0.25}}));
  EXPECT_TRUE(std::isnan(plain(D2{{kNan<double>, 0.0}})[0]));
  EXPECT_EQ(plain.tick({nothing<D2>()}), D2{});
  Ticking<Saturation, SampledLimitsIo<double>> sampled({V<float>{{-0.25F}}, std::nullopt});
  EXPECT_EQ(sampled(D2{{-3.0, 1.0}}), (D2{{-0.25, 0.5}}));
  expect_lanes<Saturation, LimitsIo, 2>();
}
TEST(Tunable, ParametersStayUntilTheyAreSetAgain) {
  Ticking<Gain, TunedGainIo<double>> gain;
  EXPECT_EQ(gain(D2{{1.0, 2.0}}), (D2{{3.0, -1.0}}));  // as configured
  gain.node.tune({V<float, 2>{{2.0F, 0.5F}}});
  EXPECT_EQ(gain(D2{{1.0, 2.0}}), (D2{{2.0, 1.0}}));
  gain.node.tune({});
  gain.reset();
  EXPECT_EQ(gain(D2{{1.0, 2.0}}), (D2{{2.0, 1.0}}));
  gain.reset({V<float, 2>{{4.0F, 0.5F}}});
  EXPECT_EQ(gain(D2{{1.0, 2.0}}), (D2{{4.0, 1.0}}));
  static_assert(sizeof(Gain<GainIo<double>>) == 1, "a constant takes no memory");

  Ticking<Saturation, SampledLimitsIo<double>> limits;
  limits.node.tune({V<float>{{-0.25F}}, std::nullopt});
  EXPECT_EQ(limits(D2{{-3.0, 1.0}}), (D2{{-0.25, 0.5}}));
}
TEST(DeadZone, IsWhatIsBeyond) {
  Ticking<DeadZone, LimitsIo<double>> zone;
  EXPECT_EQ(zone(D2{{-3.0, 1.0}}), (D2{{-2.0, 0.5}}));
  EXPECT_EQ(zone(D2{{1.5, -1.0}}), D2{});
  EXPECT_TRUE(std::isnan(zone(D2{{kNan<double>, 0.0}})[0]));
  EXPECT_EQ(zone.tick({nothing<D2>()}), D2{});
  expect_lanes<DeadZone, LimitsIo, 2>();
}

TEST(Quantizer, RoundsToSteps) {
  Ticking<Quantizer, QuantizerIo<double>> quantizer;
  for (const auto& [x, y] : {std::pair{0.3, 0.25}, {0.375, 0.5}, {-0.375, -0.5}, {7.01, 7.0}}) {
    EXPECT_EQ(quantizer(D1{{x}})[0], y);
  }
  EXPECT_TRUE(std::isnan(quantizer(D1{{kNan<double>}})[0]));
  EXPECT_EQ(quantizer.tick({nothing<D1>()})[0], 0.0);
  expect_lanes<Quantizer, QuantizerIo, 1>();
}

TEST(Product, Multiplies) {
  Ticking<Product, ProductIo<double>> product;
  EXPECT_EQ(product(D2{{2.0, 3.0}}, D2{{0.5, -1.0}}), (D2{{1.0, -3.0}}));
  EXPECT_EQ(product.tick({nothing<D2>(), nothing<D2>()}), D2{});
  EXPECT_TRUE(std::isnan(product(D2{{kNan<double>, 0.0}}, D2{})[0]));
  expect_lanes<Product, ProductIo, 2, 2>();
}

TEST(Switch, ChoosesByItsControl) {
  Ticking<Switch, SwitchIo<double>> choose;
  const D2 a{{1.0, 2.0}};
  const D2 b{{3.0, 4.0}};
  EXPECT_EQ(choose(D1{{0.5}}, a, b), a);
  EXPECT_EQ(choose(D1{{0.4}}, a, b), b);
  EXPECT_EQ(choose(D1{{kNan<double>}}, a, b), b);
  EXPECT_EQ(choose.tick({nothing<D1>(), window(a), window(b)}), b);
  expect_lanes<Switch, SwitchIo, 1, 2, 2>();
}

TEST(Mux, PutsTogetherWhatDemuxTakesApart) {
  Ticking<Mux, MuxIo<double>> mux;
  const auto y = mux(D1{{1.0}}, V<double, 3>{{2.0, 3.0, 4.0}});
  EXPECT_EQ(y, (V<double, 4>{{1.0, 2.0, 3.0, 4.0}}));
  EXPECT_EQ(mux.tick({nothing<D1>(), nothing<V<double, 3>>()}), (V<double, 4>{}));
  Demux<DemuxIo<double>> demux;
  demux.reset({});
  D2 b{};
  D1 c{};
  DemuxIo<double>::Outputs out{b, c};
  demux.callback({0}, {window(y)}, out);
  EXPECT_EQ(b, (D2{{2.0, 3.0}}));
  EXPECT_EQ(c, D1{{4.0}});
  demux.callback({1}, {nothing<V<double, 4>>()}, out);
  EXPECT_EQ(b, D2{});
  expect_lanes<Mux, MuxIo, 1, 3>();
}

TEST(LookupTable, IsNumpysInterp) {
  Ticking<LookupTable, TableIo<double>> table;
  Ticking<LookupTable, TableIo<float>> in_float;
  for (const auto& row : reference("table")) {
    expect_near(table(part<double, 1>(row, 0)), row, 1, 0.0);
    expect_near(in_float(part<float, 1>(row, 0)), row, 1, 1e-6);
  }
  for (std::size_t k = 0; k < 4; ++k) {
    using Config = TableConfig<Interpolation::linear, Outside::hold>;
    EXPECT_EQ(table(D1{{Config::x[k]}})[0], Config::y[k]);
  }
  EXPECT_TRUE(std::isnan(table(D1{{kNan<double>}})[0]));
  EXPECT_EQ(table.tick({nothing<D1>()})[0], 0.0);
  expect_lanes<LookupTable, TableIo, 1>();
}
TEST(LookupTable, ExtrapolatesOrTakesThePointBefore) {
  Ticking<LookupTable, SignalIo<double, TableConfig<Interpolation::linear, Outside::extrapolate>>>
      lines;
  EXPECT_NEAR(lines(D1{{4.0}})[0], -7.0 - 3.2, 1e-12);
  EXPECT_NEAR(lines(D1{{-2.0}})[0], 3.9, 1e-12);
  Ticking<LookupTable, StepsIo<double>> steps;
  for (const auto& [x, y] :
       {std::pair{-5.0, 2.0}, {-0.1, 2.0}, {0.0, 0.1}, {2.9, 1.0}, {9.0, -7.0}})
    EXPECT_EQ(steps(D1{{x}})[0], y);
  EXPECT_TRUE(std::isnan(steps(D1{{kNan<double>}})[0]));
  expect_lanes<LookupTable, StepsIo, 1>();
}

TEST(LookupTable2d, IsBilinear) {
  Ticking<LookupTable2d, GridIo<double>> grid;
  Ticking<LookupTable2d, GridIo<float>> in_float;
  for (const auto& row : reference("grid")) {
    expect_near(grid(part<double, 1>(row, 0), part<double, 1>(row, 1)), row, 2, 0.0);
    expect_near(in_float(part<float, 1>(row, 0), part<float, 1>(row, 1)), row, 2, 1e-6);
  }
  EXPECT_EQ(grid(D1{{9.0}}, D1{{-9.0}})[0], 0.5);
  EXPECT_TRUE(std::isnan(grid(D1{{kNan<double>}}, D1{})[0]));
  EXPECT_EQ(grid.tick({nothing<D1>(), nothing<D1>()})[0], 0.0);
  expect_lanes<LookupTable2d, GridIo, 1, 1>();
}

}  // namespace
}  // namespace eagerx::models::testing::blocks
