#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <models/nodes/butterworth_filter/butterworth_filter.hpp>

#include "tests/unit/models/csv.hpp"
#include "tests/unit/models/entity_io.hpp"

namespace eagerx::models::testing {
namespace {

FilterType filter_type(const std::string& name) {
  static const std::map<std::string, FilterType> kTypes = {{"lowpass", FilterType::lowpass},
                                                           {"highpass", FilterType::highpass},
                                                           {"bandpass", FilterType::bandpass},
                                                           {"bandstop", FilterType::bandstop}};
  return kTypes.at(name);
}

/// The filter that a row of butter_sos.csv is about.
Sections design_of(const Row& row) {
  return design_butterworth(std::stoi(row[0]), filter_type(row[1]), std::stod(row[2]),
                            std::stod(row[3]), std::stod(row[4]));
}

SecondOrderSection section_of(const Row& row) {
  return {.b0 = std::stod(row[6]),
          .b1 = std::stod(row[7]),
          .b2 = std::stod(row[8]),
          .a1 = std::stod(row[9]),
          .a2 = std::stod(row[10])};
}

std::string name_of(const Row& row) {
  return row[1] + " of order " + row[0] + " at " + row[2] + ", " + row[3] + " of " + row[4] + " Hz";
}

TEST(ButterworthDesign, EqualsScipy) {
  double worst = 0.0;
  for (const Row& row : read_csv("butter_sos.csv")) {
    const Sections design = design_of(row);
    const std::size_t index = std::stoul(row[5]);
    ASSERT_EQ(design.count, butterworth_section_count(std::stoi(row[0]), filter_type(row[1])));
    ASSERT_LT(index, design.count);
    const SecondOrderSection& ours = design.sections[index];
    const SecondOrderSection scipys = section_of(row);
    // The gain of the first section may be small: its numerator is compared relative to it.
    const double scale = scipys.b0;
    EXPECT_NEAR(ours.b0, scipys.b0, 1e-12 * scale) << name_of(row);
    EXPECT_NEAR(ours.b1, scipys.b1, 1e-12 * scale) << name_of(row);
    EXPECT_NEAR(ours.b2, scipys.b2, 1e-12 * scale) << name_of(row);
    EXPECT_NEAR(ours.a1, scipys.a1, 1e-12) << name_of(row);
    EXPECT_NEAR(ours.a2, scipys.a2, 1e-12) << name_of(row);
    for (const double error :
         {(ours.b0 - scipys.b0) / scale, (ours.b1 - scipys.b1) / scale,
          (ours.b2 - scipys.b2) / scale, ours.a1 - scipys.a1, ours.a2 - scipys.a2}) {
      worst = std::max(worst, std::abs(error));
    }
  }
  RecordProperty("largest_coefficient_error", std::to_string(worst * 1e15) + "e-15");
}

std::complex<double> response(const SecondOrderSection& s, double angle) {
  const std::complex<double> delay = std::polar(1.0, -angle);
  return (s.b0 + delay * (s.b1 + delay * s.b2)) / (1.0 + delay * (s.a1 + delay * s.a2));
}

/// Where scipy's order of the sections depends on rounding, the filter as a whole is compared.
TEST(ButterworthDesign, SymmetricBandFiltersHaveScipysResponse) {
  constexpr std::array kAngles = {0.0, 0.3, 1.2, 1.5707, 1.9, 3.0};
  std::map<std::string, std::array<std::complex<double>, kAngles.size()>> scipys;
  std::map<std::string, Sections> ours;
  for (const Row& row : read_csv("butter_symmetric.csv")) {
    const std::string name = name_of(row);
    if (!ours.contains(name)) scipys[name].fill(1.0);
    ours[name] = design_of(row);
    for (std::size_t i = 0; i < kAngles.size(); ++i) {
      scipys[name][i] *= response(section_of(row), kAngles[i]);
    }
  }
  for (const auto& [name, design] : ours) {
    for (std::size_t i = 0; i < kAngles.size(); ++i) {
      std::complex<double> product = 1.0;
      for (std::size_t s = 0; s < design.count; ++s) {
        product *= response(design.sections[s], kAngles[i]);
      }
      EXPECT_LT(std::abs(product - scipys[name][i]), 1e-11) << name << " angle " << kAngles[i];
    }
  }
}

TEST(ButterworthDesign, PassesDcAndHalvesThePowerAtTheCorner) {
  const Sections design = design_butterworth(5, FilterType::lowpass, 7.0, 7.0, 60.0);
  double dc = 1.0;
  std::complex<double> corner = 1.0;
  for (std::size_t i = 0; i < design.count; ++i) {
    dc *= response(design.sections[i], 0.0).real();
    corner *= response(design.sections[i], 2.0 * 3.14159265358979 * 7.0 / 60.0);
  }
  EXPECT_NEAR(dc, 1.0, 1e-12);
  EXPECT_NEAR(std::norm(corner), 0.5, 1e-12);
}

TEST(ButterworthDesign, IsDoneByTheCompiler) {
  constexpr Sections kDesign = design_butterworth(8, FilterType::bandstop, 5.0, 12.0, 100.0);
  static_assert(kDesign.count == 8);
  const Sections at_run_time = design_butterworth(8, FilterType::bandstop, 5.0, 12.0, 100.0);
  for (std::size_t i = 0; i < kDesign.count; ++i) {
    EXPECT_EQ(kDesign.sections[i].a1, at_run_time.sections[i].a1);  // the same bits
    EXPECT_EQ(kDesign.sections[i].b1, at_run_time.sections[i].b1);
  }
}

template <class Io, class Message>
Message filter_sample(ButterworthFilter<Io>& filter, const Message& sample) {
  Message filtered{};
  typename Io::Outputs out{filtered};
  filter.callback({0}, {{&sample, 1, 1}}, out);
  return filtered;
}

/// Runs the columns of butter_response.csv through the filter; returns the largest error.
template <class Config, class Rate, class Real>
double response_error(const std::string& name) {
  using Io = FilterIo<Real, Config, Rate, Real>;
  ButterworthFilter<Io> impulse;
  ButterworthFilter<Io> step;
  ButterworthFilter<Io> noise;
  double worst = 0.0;
  int samples = 0;
  for (const Row& row : read_csv("butter_response.csv")) {
    if (row[0] != name) continue;
    const Real first = samples == 0 ? Real(1) : Real(0);
    const auto got_impulse = static_cast<double>(filter_sample(impulse, first));
    const auto got_step = static_cast<double>(filter_sample(step, Real(1)));
    const auto got_noise =
        static_cast<double>(filter_sample(noise, static_cast<Real>(std::stod(row[4]))));
    worst =
        std::max({worst, std::abs(got_impulse - std::stod(row[2])),
                  std::abs(got_step - std::stod(row[3])), std::abs(got_noise - std::stod(row[5]))});
    ++samples;
  }
  EXPECT_EQ(samples, 80);
  return worst;
}

TEST(ButterworthFilter, RespondsAsSosfilt) {
  EXPECT_LT((response_error<Low2, eagerx::Rate<60>, double>("low2")), 1e-14);
  EXPECT_LT((response_error<High3, eagerx::Rate<30>, double>("high3")), 1e-14);
  EXPECT_LT((response_error<Band4, eagerx::Rate<60>, double>("band4")), 1e-13);
  EXPECT_LT((response_error<Stop8, eagerx::Rate<100>, double>("stop8")), 1e-12);
}

TEST(ButterworthFilter, RespondsAsSosfiltInFloat) {
  EXPECT_LT((response_error<Low2, eagerx::Rate<60>, float>("low2")), 1e-6);
  EXPECT_LT((response_error<High3, eagerx::Rate<30>, float>("high3")), 1e-6);
  EXPECT_LT((response_error<Band4, eagerx::Rate<60>, float>("band4")), 1e-5);
  EXPECT_LT((response_error<Stop8, eagerx::Rate<100>, float>("stop8")), 1e-4);
}

TEST(ButterworthFilter, FiltersEveryElementByItself) {
  using Message = Array<float, 3>;
  using Io = FilterIo<float, Low2, eagerx::Rate<60>, Message>;
  ButterworthFilter<Io> together;
  ButterworthFilter<FilterIo<float, Low2, eagerx::Rate<60>, float>> alone;
  for (int i = 0; i < 10; ++i) {
    const auto x = static_cast<float>(i * i % 7);
    const Message filtered = filter_sample(together, Message{{1.0F, x, -2.0F}});
    EXPECT_EQ(filtered[1], filter_sample(alone, x));
    EXPECT_GT(filtered[0], 0.0F);
    EXPECT_LT(filtered[2], 0.0F);
  }
}

TEST(ButterworthFilter, ForgetsAtAReset) {
  using Io = FilterIo<float, Band4, eagerx::Rate<60>, float>;
  ButterworthFilter<Io> filter;
  const float first = filter_sample(filter, 1.0F);
  EXPECT_NE(filter_sample(filter, 1.0F), first);
  filter.reset({});
  EXPECT_EQ(filter_sample(filter, 1.0F), first);
}

TEST(ButterworthFilter, TakesZeroUntilASignalComes) {
  using Io = FilterIo<float, Low2, eagerx::Rate<60>, float, Skipped>;
  ButterworthFilter<Io> filter;
  const float unused = 7.0F;
  float filtered = 1.0F;
  Io::Outputs out{filtered};
  filter.callback({0}, {{&unused, 0, 0}}, out);
  EXPECT_EQ(filtered, 0.0F);
}

}  // namespace
}  // namespace eagerx::models::testing
