// A recursive mean.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <type_traits>

namespace eagerx::models {

/// a ← ((n − 1)·a + x)/n for every element x of the last `signal`, a = 0 at a reset; `filtered` is
/// a. As long as no signal has come (skipped connections), x = 0.
/// Source: eagerx_tutorials, tutorial 4.
template <class Io>
class MovingAverageFilter {
 public:
  void reset(const typename Io::States& /*states*/) { mean_ = {}; }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    using Result = std::remove_cvref_t<decltype(out.filtered)>;
    static_assert(size_of<Result> == kElements,
                  "MovingAverageFilter: `filtered` must have as many elements as `signal`");
    constexpr auto kCount = static_cast<Real>(Io::Config::n);
    const Message signal = in.signal.back_or(Message{});
    for (std::size_t i = 0; i < kElements; ++i) {
      mean_[i] = ((kCount - Real(1)) * mean_[i] + static_cast<Real>(element(signal, i))) / kCount;
      element(out.filtered, i) = static_cast<ScalarOf<Result>>(mean_[i]);
    }
  }

 private:
  using Real = typename Io::Real;
  using Message = typename decltype(Io::Inputs::signal)::value_type;
  static constexpr std::size_t kElements = size_of<Message>;
  static_assert(Io::Config::n >= 1, "MovingAverageFilter: `n` must be at least 1");

  std::array<Real, kElements> mean_{};
};

}  // namespace eagerx::models
