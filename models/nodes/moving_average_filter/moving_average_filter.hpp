// A recursive mean.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <models/nodes/block.hpp>
#include <models/nodes/butterworth_filter/filter_start.hpp>
#include <type_traits>

namespace eagerx::models {

/// a ← ((n − 1)·a + x)/n for every element x of the last `signal`, a = 0 at a reset, or with
/// `initial: measured` the first finite x; `filtered` is a. As long as no signal has come (skipped
/// connections), x = 0. An x that is not finite passes, and leaves a as it is. Computed as a + (x −
/// a)/n, compensated, so that no n makes a stand still. Source: eagerx_tutorials, tutorial 4.
template <class Io>
class MovingAverageFilter {
 public:
  void reset(const typename Io::States& /*states*/) {
    mean_ = {};
    start_.reset();
  }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    using Result = std::remove_cvref_t<decltype(out.filtered)>;
    static_assert(size_of<Result> == kElements,
                  "MovingAverageFilter: `filtered` must have as many elements as `signal`");
    constexpr auto kCount = static_cast<Real>(Io::Config::n);
    const Message signal = in.signal.back_or(Message{});
    for (std::size_t i = 0; i < kElements; ++i) {
      const auto x = static_cast<Real>(element(signal, i));
      const TruthOf<Real> begins = start_.begins(i, in.signal.empty(), x);
      mean_[i] = {select(begins, x, mean_[i].value), mean_[i].rest};
      const auto after = mean_[i].plus((x - mean_[i].value) / kCount);
      const auto right = eagerx::isfinite(x) && eagerx::isfinite(after.value);
      mean_[i] = {select(right, after.value, mean_[i].value),
                  select(right, after.rest, mean_[i].rest)};
      element(out.filtered, i) =
          static_cast<ScalarOf<Result>>(select(eagerx::isfinite(x), mean_[i].value, x));
    }
  }

 private:
  using Real = typename Io::Real;
  using Message = typename decltype(Io::Inputs::signal)::value_type;
  static constexpr std::size_t kElements = size_of<Message>;
  static_assert(Io::Config::n >= 1, "MovingAverageFilter: `n` must be at least 1");

  std::array<CompensatedSum<Real>, kElements> mean_{};
  [[no_unique_address]] FilterStart<Real, kElements, Io::Config::initial> start_{};
};

}  // namespace eagerx::models
