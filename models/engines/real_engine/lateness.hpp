// How late something was, counted by classes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace eagerx::models {

/// A histogram of lateness with fixed classes; all bytes are zero at first.
class Lateness {
 public:
  struct Class {
    std::int64_t below_ns;
    const char* name;
  };
  static constexpr std::array<Class, 9> kClasses = {{{10'000, "late by less than 10 us"},
                                                     {20'000, "late by 10 to 20 us"},
                                                     {50'000, "late by 20 to 50 us"},
                                                     {100'000, "late by 50 to 100 us"},
                                                     {200'000, "late by 100 to 200 us"},
                                                     {500'000, "late by 200 to 500 us"},
                                                     {1'000'000, "late by 0.5 to 1 ms"},
                                                     {10'000'000, "late by 1 to 10 ms"},
                                                     {INT64_MAX, "late by 10 ms or more"}}};

  void add(std::int64_t late_ns) {
    std::size_t i = 0;
    while (late_ns >= kClasses[i].below_ns && i + 1 < kClasses.size()) ++i;
    ++counts_[i];
    if (late_ns > worst_ns_) worst_ns_ = late_ns;
  }
  std::uint64_t count(std::size_t i) const { return counts_[i]; }
  std::int64_t worst_ns() const { return worst_ns_; }

  /// f(name, count) for each class and for the worst.
  template <class F>
  void for_each_count(F&& f) const {
    constexpr std::int64_t kNsPerUs = 1'000;
    for (std::size_t i = 0; i < kClasses.size(); ++i) f(kClasses[i].name, counts_[i]);
    f("latest by us", static_cast<std::uint64_t>(worst_ns_ / kNsPerUs));
  }

 private:
  std::array<std::uint64_t, kClasses.size()> counts_{};
  std::int64_t worst_ns_ = 0;
};

}  // namespace eagerx::models
