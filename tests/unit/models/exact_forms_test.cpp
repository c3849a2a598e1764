// Forms that keep their digits against the textbook's, in numbers of more digits; where filters
// begin.
#include <gtest/gtest.h>

#include <cmath>
#include <models/nodes/discrete_transfer_function/discrete_transfer_function.hpp>
#include <models/nodes/moving_average_filter/moving_average_filter.hpp>
#include <models/nodes/reference/reference.hpp>

#include "tests/unit/models/block_signals.hpp"

namespace eagerx::models::testing::long_runs {
namespace {

/// y[n] = (Σ b·x − Σ a·y)/a[0] of the signals so far, in the longest numbers there are.
template <class Config>
class DirectForm {
 public:
  double next(double signal) {
    for (std::size_t k = 3; k > 0; --k) x_[k] = x_[k - 1], y_[k] = y_[k - 1];
    x_[0] = static_cast<long double>(signal);
    long double sum = 0.0L;
    for (std::size_t k = 0; k < Config::b.size(); ++k) sum += wide(Config::b[k]) * x_[k];
    for (std::size_t k = 1; k < Config::a.size(); ++k) sum -= wide(Config::a[k]) * y_[k];
    y_[0] = sum / wide(Config::a[0]);
    return static_cast<double>(y_[0]);
  }

 private:
  static constexpr long double wide(double x) { return static_cast<long double>(x); }

  std::array<long double, 4> x_{}, y_{};
};

template <class Config>
void expect_direct_form(double tolerance) {
  blocks::Ticking<DiscreteTransferFunction, SignalIo<double, Config>> node;
  DirectForm<Config> direct;
  for (Seq n = 0; n < 20'000; ++n) {
    const auto x = static_cast<double>(Around<3>::at(n, 0));
    const double right = direct.next(x);
    ASSERT_NEAR(node(V<double>{{x}})[0], right, tolerance * std::max(1.0, std::abs(right))) << n;
  }
}

/// Three poles near 1, and a[0] that is not 1: (1 − 0.99/z)(1 − 0.98/z)(1 − 0.995/z)·2
struct ThreeConfig {
  static constexpr std::array<double, 2> b = {0.5, -0.495};
  static constexpr std::array<double, 4> a = {2.0, -5.93, 5.8607, -1.930698};
};

TEST(DiscreteTransferFunction, InDifferencesIsTheSameFilter) {
  expect_direct_form<LowTransferConfig>(1e-9);
  expect_direct_form<SumTransferConfig>(1e-12);
  expect_direct_form<ThreeConfig>(1e-9);
  expect_direct_form<blocks::TransferConfig>(1e-12);
}

/// Over 100,000 s from 49.9 to 80 Hz: 6.5 million turns.
TEST(Reference, KeepsThePhaseOfALongSweep) {
  using Config = LongReferenceConfig<ReferenceShape::chirp>;
  using Io = With<blocks::SourceIo<float, Config>, Config>;
  struct TunedIo : Io {
    struct States {
      std::optional<float> frequency{};
    };
  };
  eagerx::models::Reference<Io> node;
  eagerx::models::Reference<TunedIo> tuned;
  node.reset({});
  tuned.reset({});
  for (const Seq n : {100ULL, 3'600'123ULL, 67'108'877ULL, 100'000'099ULL, 100'000'111ULL,
                      150'000'200ULL, 1'000'000'077ULL}) {
    V<float> y{};
    V<float> y_of_tuned{};
    typename Io::Outputs out{y};
    typename TunedIo::Outputs out_of_tuned{y_of_tuned};
    node.callback(Tick{n}, {}, out);
    tuned.callback(Tick{n}, {}, out_of_tuned);
    const auto right = [n](long double f) {
      const long double t = static_cast<long double>(n) / 1000.0L - 0.1L;
      const long double sweep = std::min(t, 100'000.0L);
      const long double turns =
          f * sweep + (80.0L - f) * sweep * sweep / 200'000.0L + 80.0L * (t - sweep);
      return 0.5 + 2.0 * static_cast<double>(std::sin(2.0L * 3.14159265358979323846L *
                                                      (turns - std::floor(turns))));
    };
    EXPECT_NEAR(static_cast<double>(y[0]), right(49.9L), 2e-4) << n;
    EXPECT_NEAR(static_cast<double>(y_of_tuned[0]), right(static_cast<long double>(49.9F)), 2e-4)
        << n;
  }
}

TEST(CompensatedSum, CountsOnWhereFloatHasNoOnes) {
  CompensatedSum<float> count;
  count.set(16'777'216.0F);
  for (int n = 0; n < 9; ++n) count = count.plus(1.0F);
  EXPECT_EQ(count.value, 16'777'224.0F);  // of 2^24 + 9, which lies between two floats
  EXPECT_EQ(count.rest, 1.0F);
}

template <template <class> class Node, class Io>
std::vector<float> filtered(const std::vector<float>& signal) {
  Node<Io> node{};
  node.reset({});
  std::vector<float> result;
  for (std::size_t n = 0; n < signal.size(); ++n) {
    const V<float> x{{signal[n]}};
    V<float> y{};
    typename Io::Outputs out{y};
    node.callback(Tick{n}, {{&x, n > 0 ? 1U : 0U, n > 0 ? 1U : 0U}}, out);
    result.push_back(y[0]);
  }
  return result;
}
struct MeasuredMeanConfig : MeanConfig {
  static constexpr auto initial = FilterInitial::measured;
};
template <FilterType Type>
struct StartConfig : FastFilterConfig {
  static constexpr auto type = Type;
};
struct StartBandConfig : StartConfig<FilterType::bandpass> {
  static constexpr std::array<double, 2> cutoff_hz = {40.0, 90.0};
};

TEST(Filters, BeginAtTheirFirstMeasurement) {
  // No message at first, then one that is not finite; neither is a measurement.
  std::vector<float> signal(300, 1.3F);
  signal[1] = blocks::kNan<float>;
  const auto expect_rest_at = [&](const std::vector<float>& y, float value) {
    EXPECT_EQ(y[0], 0.0F);
    EXPECT_TRUE(std::isnan(y[1]));
    for (std::size_t n = 2; n < y.size(); ++n) ASSERT_NEAR(y[n], value, 1e-5F) << n;
  };
  expect_rest_at(filtered<ButterworthFilter, FilteredIo<float, FastFilterConfig>>(signal), 1.3F);
  expect_rest_at(
      filtered<ButterworthFilter, FilteredIo<float, LowFilterConfig<FilterInitial::measured>>>(
          signal),
      1.3F);
  expect_rest_at(
      filtered<ButterworthFilter, FilteredIo<float, StartConfig<FilterType::highpass>>>(signal),
      0.0F);
  expect_rest_at(filtered<ButterworthFilter, FilteredIo<float, StartBandConfig>>(signal), 0.0F);
  expect_rest_at(filtered<MovingAverageFilter, FilteredIo<float, MeasuredMeanConfig>>(signal),
                 1.3F);
  // From there on it is the same filter: a step of 1 more than what it began at.
  signal.assign(300, 0.0F);
  std::vector<float> shifted(300, 1.3F);
  for (std::size_t n = 20; n < 300; ++n) signal[n] += 1.0F, shifted[n] += 1.0F;
  const auto from_zero = filtered<ButterworthFilter, FilteredIo<float, FastFilterConfig>>(signal);
  const auto from_there = filtered<ButterworthFilter, FilteredIo<float, FastFilterConfig>>(shifted);
  for (std::size_t n = 1; n < 300; ++n) ASSERT_NEAR(from_there[n], from_zero[n] + 1.3F, 1e-5F) << n;
}

TEST(Filters, BeginInEachLane) {
  using P = Simd<float, 4>;
  using Io = FilteredIo<P, FastFilterConfig>;
  ButterworthFilter<Io> node;
  node.reset({});
  for (Seq n = 0; n < 50; ++n) {
    V<P> x{{P(2.0F)}};
    set_lane(x[0], 1, n < 20 ? blocks::kNan<float> : -1.0F);
    V<P> y{};
    Io::Outputs out{y};
    node.callback(Tick{n}, {{&x, 1, 1}}, out);
    EXPECT_NEAR(lane(y[0], 0), 2.0F, 1e-5F) << n;
    if (n >= 20) {
      EXPECT_NEAR(lane(y[0], 1), -1.0F, 1e-5F) << n;
    }
  }
}

}  // namespace
}  // namespace eagerx::models::testing::long_runs
