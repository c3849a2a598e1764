// Histograms of lateness and durations.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace eagerx::models {

/// A histogram of times with fixed classes, which `Names::kClasses` and `Names::kWorst` name; all
/// bytes are zero at first.
template <class Names>
class TimeHistogram {
 public:
  static constexpr std::array<std::int64_t, 9> kBelowNs = {
      10'000, 20'000, 50'000, 100'000, 200'000, 500'000, 1'000'000, 10'000'000, INT64_MAX};

  void add(std::int64_t ns) {
    std::size_t i = 0;
    while (ns >= kBelowNs[i] && i + 1 < kBelowNs.size()) ++i;
    ++counts_[i];
    if (ns > worst_ns_) worst_ns_ = ns;
  }
  std::uint64_t count(std::size_t i) const { return counts_[i]; }
  std::int64_t worst_ns() const { return worst_ns_; }

  /// Calls f(name, count) for each class and for the worst.
  template <class F>
  void for_each_count(F&& f) const {
    constexpr std::int64_t kNsPerUs = 1'000;
    for (std::size_t i = 0; i < kBelowNs.size(); ++i) f(Names::kClasses[i], counts_[i]);
    f(Names::kWorst, static_cast<std::uint64_t>(worst_ns_ / kNsPerUs));
  }

 private:
  std::array<std::uint64_t, kBelowNs.size()> counts_{};
  std::int64_t worst_ns_ = 0;
};

/// How much later than due an instant began.
struct LatenessNames {
  static constexpr std::array<const char*, 9> kClasses = {
      "late by less than 10 us", "late by 10 to 20 us",   "late by 20 to 50 us",
      "late by 50 to 100 us",    "late by 100 to 200 us", "late by 200 to 500 us",
      "late by 0.5 to 1 ms",     "late by 1 to 10 ms",    "late by 10 ms or more"};
  static constexpr const char* kWorst = "latest by us";
};
using Lateness = TimeHistogram<LatenessNames>;

/// From the beginning of an instant, before its sensors are measured, until its actions are sent.
struct LatencyNames {
  static constexpr std::array<const char*, 9> kClasses = {
      "acted within 10 us",       "acted after 10 to 20 us",   "acted after 20 to 50 us",
      "acted after 50 to 100 us", "acted after 100 to 200 us", "acted after 200 to 500 us",
      "acted after 0.5 to 1 ms",  "acted after 1 to 10 ms",    "acted after 10 ms or more"};
  static constexpr const char* kWorst = "slowest action after us";
};
using Latency = TimeHistogram<LatencyNames>;

}  // namespace eagerx::models
