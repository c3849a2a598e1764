#include <gtest/gtest.h>

#include <map>
#include <models/nodes/moving_average_filter/moving_average_filter.hpp>
#include <models/nodes/windowed_butterworth/windowed_butterworth.hpp>
#include <vector>

#include "tests/unit/models/csv.hpp"
#include "tests/unit/models/entity_io.hpp"

namespace eagerx::models::testing {
namespace {

TEST(MovingAverageFilter, IsTheRecursiveMean) {
  using Io = MeanIo<double, float, Array<float, 1>>;
  MovingAverageFilter<Io> filter;
  filter.reset({});
  double mean = 0.0;
  for (const float x : {1.0F, -2.0F, 0.5F, 0.5F, 3.0F}) {
    Array<float, 1> filtered{};
    Io::Outputs out{filtered};
    filter.callback({0}, {{&x, 1, 1}}, out);
    mean = (3.0 * mean + static_cast<double>(x)) / 4.0;
    EXPECT_EQ(filtered[0], static_cast<float>(mean));
  }
}

TEST(MovingAverageFilter, FiltersEveryElementFromZeroAndForgetsAtAReset) {
  using Io = MeanIo<float, TwoFloats, TwoFloats, Skipped>;
  MovingAverageFilter<Io> filter;
  const TwoFloats signal{{4.0F, -8.0F}};
  for (int episode = 0; episode < 2; ++episode) {
    filter.reset({});
    TwoFloats filtered{{9.0F, 9.0F}};
    Io::Outputs out{filtered};
    filter.callback({0}, {{&signal, 0, 0}}, out);
    EXPECT_EQ(filtered, TwoFloats{});
    filter.callback({1}, {{&signal, 1, 1}}, out);
    EXPECT_EQ(filtered, (TwoFloats{{1.0F, -2.0F}}));
  }
}

/// Element 1 of the signal goes through `Config`; the ring has room for 16 messages.
template <class Config, class Rate, class Real>
std::vector<double> run_windowed(const std::vector<double>& samples) {
  using Io = WindowedIo<Real, Config, Rate, Config::order, false>;
  WindowedButterworth<Io> filter;
  filter.reset({});
  std::array<TwoFloats, 16> ring{};
  std::vector<double> result;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    ring[i % ring.size()] = {{7.0F, static_cast<float>(samples[i])}};
    Array<float, 1> filtered{};
    typename Io::Outputs out{filtered};
    filter.callback({i}, {{ring.data(), i + 1}}, out);
    result.push_back(static_cast<double>(filtered[0]));
  }
  return result;
}

/// scipy's impulse response of a case in butter_response.csv.
std::vector<double> impulse_response(const std::string& name) {
  std::vector<double> result;
  for (const Row& row : read_csv("butter_response.csv")) {
    if (row[0] == name) result.push_back(std::stod(row[2]));
  }
  return result;
}

/// A filter that begins at rest with the first of N samples is their sum with the impulse response.
template <class Config, class Rate>
void expect_first_part_of_response(const std::string& name) {
  constexpr std::size_t kCount = Config::order;
  const std::vector<double> response = impulse_response(name);
  ASSERT_GE(response.size(), kCount);
  const std::vector<double> samples = {0.5,  -1.25, 2.0, 0.75, 0.125, -0.5,  1.5, 1.0, 1.0,  0.25,
                                       -2.0, 3.0,   0.0, 0.0,  0.5,   -0.75, 1.0, 0.5, -1.5, 0.25};
  const auto in_float = run_windowed<Config, Rate, float>(samples);
  const auto in_double = run_windowed<Config, Rate, double>(samples);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    double expected = samples[i];  // too few samples: the last one
    if (i + 1 >= kCount) {
      expected = 0.0;
      for (std::size_t k = 0; k < kCount; ++k) expected += response[k] * samples[i - k];
    }
    EXPECT_NEAR(in_double[i], expected, 2e-7) << name << " sample " << i;
    EXPECT_NEAR(in_float[i], expected, 2e-6) << name << " sample " << i;
  }
}

TEST(WindowedButterworth, IsTheFirstPartOfScipysResponse) {
  expect_first_part_of_response<Low2, eagerx::Rate<60>>("low2");
  expect_first_part_of_response<High3, eagerx::Rate<30>>("high3");
  expect_first_part_of_response<Band4, eagerx::Rate<60>>("band4");
  expect_first_part_of_response<Stop8, eagerx::Rate<100>>("stop8");
}

TEST(WindowedButterworth, LooksAtTheLastOfALongerWindowAndIsZeroWithoutMessages) {
  using Io = WindowedIo<double, Low2, eagerx::Rate<60>, 4, false>;
  const auto response = impulse_response("low2");
  std::array<TwoFloats, 16> ring{};
  for (std::size_t i = 0; i < 4; ++i) ring[i] = {{0.0F, static_cast<float>(i)}};
  WindowedButterworth<Io> filter;
  Array<float, 1> filtered{{9.0F}};
  Io::Outputs out{filtered};
  filter.callback({0}, {{ring.data(), 0, 0}}, out);
  EXPECT_EQ(filtered[0], 0.0F);
  filter.callback({3}, {{ring.data(), 4}}, out);
  EXPECT_NEAR(filtered[0], response[0] * 3.0 + response[1] * 2.0, 1e-6);
}

}  // namespace
}  // namespace eagerx::models::testing
