// Layers over SIMD vectors against the same layers over plain numbers, every bit of every lane.
// extra.cmake compiles this for the instruction set of this machine, too.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <eagerx/lanes.hpp>
#include <eagerx/policy/branches.hpp>
#include <eagerx/policy/elementwise.hpp>
#include <eagerx/policy/recurrent.hpp>
#include <eagerx/policy/simd.hpp>
#include <limits>
#include <memory>
#include <span>

#include "tests/unit/runtime/numbers.hpp"

namespace {

using eagerx::Activation;
using eagerx::DenseWeights;
using eagerx::test::bits_of;
using eagerx::test::Numbers;

constexpr std::size_t kLanes = eagerx::kSimdLanes<float>;
using Real = eagerx::Simd<float, kLanes>;

/// The inputs of a lane; some lanes have one number that is not an ordinary one.
void fill_lane(std::size_t k, Numbers& numbers, std::span<float> one, Real* simds) {
  constexpr float kOdd[] = {std::numeric_limits<float>::quiet_NaN(),
                            std::numeric_limits<float>::infinity(), -0.0F, 1e-42F};
  for (std::size_t i = 0; i < one.size(); ++i) {
    const bool odd = k % 3 == 1 && i == k % one.size();
    one[i] = odd ? kOdd[k / 3 % 4] : numbers.next();
    set_lane(simds[i], static_cast<int>(k), one[i]);
  }
}

template <std::size_t In>
struct Inputs {
  float one[kLanes][In];
  Real simds[In];

  explicit Inputs(Numbers& numbers) {
    for (std::size_t k = 0; k < kLanes; ++k) fill_lane(k, numbers, one[k], simds);
  }
};

/// One lane of the outputs against plain ones.
void expect_same(const char* what, std::size_t inputs, std::size_t lane_at,
                 std::span<const Real> simds, std::span<const float> one) {
  for (std::size_t i = 0; i < one.size(); ++i) {
    const float vectorized = lane(simds[i], static_cast<int>(lane_at));
    ASSERT_EQ(bits_of(vectorized), bits_of(one[i]))
        << what << ", " << inputs << " inputs, output " << i << " of " << one.size() << ", lane "
        << lane_at << ": " << vectorized << " instead of " << one[i];
  }
}

/// f(x, y) over plain numbers and over SIMD vectors.
template <std::size_t In, std::size_t Out, class F>
void compare(const char* what, const Inputs<In>& x, F&& f) {
  Real simds[Out];
  f(x.simds, simds);
  for (std::size_t k = 0; k < kLanes && !::testing::Test::HasFatalFailure(); ++k) {
    float one[Out];
    f(x.one[k], one);
    expect_same(what, In, k, simds, one);
  }
}

template <Activation A, std::size_t In, std::size_t Out>
void compare_dense() {
  Numbers numbers(In * 131 + Out);
  const auto layer = std::make_unique<DenseWeights<In, Out>>();
  for (float& w : layer->w) w = numbers.next();
  for (float& b : layer->b) b = numbers.next();
  const auto x = std::make_unique<Inputs<In>>(numbers);
  compare<In, Out>("dense", *x,
                   [&](const auto& from, auto& to) { eagerx::dense<A>(*layer, from, to, 0.3F); });
}

template <std::size_t In>
void compare_outputs() {
  compare_dense<Activation::identity, In, 1>();
  compare_dense<Activation::relu, In, 2>();
  compare_dense<Activation::tanh, In, 3>();
  compare_dense<Activation::elu, In, 7>();
  compare_dense<Activation::leaky_relu, In, 8>();
  compare_dense<Activation::silu, In, 9>();
  compare_dense<Activation::gelu, In, 17>();
  compare_dense<Activation::gelu_tanh, In, 12>();
  compare_dense<Activation::softplus, In, 33>();
  compare_dense<Activation::sigmoid, In, 16>();
}

TEST(PolicySimd, DenseLayersOfAllForms) {
  compare_outputs<1>();
  compare_outputs<3>();
  compare_outputs<8>();
  compare_outputs<9>();
  compare_outputs<16>();
  compare_outputs<20>();
  compare_outputs<64>();
}

TEST(PolicySimd, NormsAndStatistics) {
  Numbers numbers(7);
  eagerx::NormWeights<19> norm{};
  for (float& x : norm.gamma) x = numbers.next();
  for (float& x : norm.beta) x = numbers.next();
  norm.epsilon = 1e-5F;
  eagerx::ObservationStatistics<19> statistics{};
  for (double& x : statistics.mean) x = static_cast<double>(numbers.next()) / 3;
  for (double& x : statistics.deviation) x = 0.1 + static_cast<double>(numbers.next()) / 7;
  statistics.clip = 5.0;
  const Inputs<19> x(numbers);
  compare<19, 19>("norm", x, [&](const auto& from, auto& to) {
    for (std::size_t i = 0; i < 19; ++i) to[i] = from[i];
    eagerx::layer_norm(norm, to);
  });
  compare<19, 19>("statistics", x, [&](const auto& from, auto& to) {
    for (std::size_t i = 0; i < 19; ++i) to[i] = from[i];
    eagerx::normalize(statistics, to);
  });
}

constexpr float kOne[] = {0.7F};
constexpr float kEach[] = {0.1F, -2.0F, 3.0F, -0.0F, 5.0F, 1e-3F,
                           7.0F, -8.0F, 9.0F, 1.0F,  2.0F, 0.3F};
constexpr std::uint16_t kFrom[] = {11, 0, 3, 3, 7};

TEST(PolicySimd, ConstantsFunctionsAndBranches) {
  namespace policy = eagerx::policy;
  Numbers numbers(11);
  const Inputs<12> given(numbers);
#define EXPECT_SAME(outputs, ...) \
  compare<12, outputs>(#__VA_ARGS__, given, [&](const auto& x, auto& y) { __VA_ARGS__; })
  EXPECT_SAME(12, policy::add(kOne, x, y));
  EXPECT_SAME(12, policy::subtract(kEach, x, y));
  EXPECT_SAME(12, policy::multiply(kEach, x, y));
  EXPECT_SAME(12, policy::divide(kOne, x, y));
  EXPECT_SAME(12, policy::at_least(kEach, x, y));
  EXPECT_SAME(12, policy::at_most(kOne, x, y));
  EXPECT_SAME(5, policy::reorder(kFrom, x, y));
  EXPECT_SAME(12, policy::apply<Activation::tanh>(x, y));
  EXPECT_SAME(12, policy::sin(x, y));
  EXPECT_SAME(12, policy::cos(x, y));
  EXPECT_SAME(12, policy::exp(x, y));
  EXPECT_SAME(12, policy::abs(x, y));
  EXPECT_SAME(12, policy::sqrt(x, y));
  EXPECT_SAME(12, policy::above_zero(x, y));
  EXPECT_SAME(12, policy::round_to_even(x, y));
  EXPECT_SAME(12, policy::floor(x, y));
  EXPECT_SAME(12, policy::ceil(x, y));
  EXPECT_SAME(4, policy::row_sum(x, y));
  EXPECT_SAME(3, policy::row_mean(x, y));
  EXPECT_SAME(2, policy::row_norm(x, y));
  EXPECT_SAME(4, policy::sum(y, policy::slice<0, 4>(x), policy::slice<4, 1>(x)));
  EXPECT_SAME(4, policy::difference(y, policy::slice<3, 1>(x), policy::slice<4, 4>(x)));
  EXPECT_SAME(6, policy::product(y, policy::slice<0, 6>(x), policy::slice<6, 6>(x)));
  EXPECT_SAME(6, policy::quotient(y, policy::slice<6, 6>(x), policy::slice<0, 6>(x)));
  EXPECT_SAME(
      4, policy::select(y, policy::slice<0, 1>(x), policy::slice<1, 4>(x), policy::slice<5, 4>(x)));
  EXPECT_SAME(9, policy::join(y, policy::slice<7, 5>(x), policy::slice<0, 4>(x)));
#undef EXPECT_SAME
}

}  // namespace
