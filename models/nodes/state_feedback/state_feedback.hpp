// A linear state-feedback controller.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/rate.hpp>
#include <models/nodes/action_limits/per_element.hpp>
#include <models/nodes/block.hpp>

namespace eagerx::models {

/// u [rows] = clamp(reference_gain·reference − gain·x, low, high). If x or reference is not finite
/// or is missing, u is zero, moved into its limits.
template <class Io>
class StateFeedback {
 public:
  void reset(const typename Io::States& states) { tune(states); }
  void tune([[maybe_unused]] const typename Io::States& states) {
    if constexpr (requires { states.gain; }) gain_.reset(states.gain, kGain);
    if constexpr (requires { states.reference_gain; })
      reference_gain_.reset(states.reference_gain, kReferenceGain);
  }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    Real sum_of_zeros(0);  // NaN if an input is not finite
    const auto x = numbers(in.x, sum_of_zeros);
    static_assert(kGain.size() == kRows * x.size(),
                  "StateFeedback: `gain` has `rows` times as many values as `x` has elements");
    std::array<Real, kRows> forward{};
    if constexpr (requires { in.reference; }) {
      const auto r = numbers(in.reference, sum_of_zeros);
      static_assert(kReferenceGain.size() == kRows * r.size(),
                    "StateFeedback: `reference_gain` has `rows` times as many values as "
                    "`reference` has elements");
      for (std::size_t i = 0; i < kRows; ++i)
        forward[i] = forward[i] =
            row_times<Real>(reference_gain_.or_constants(kReferenceGain), i, r);
    }
    const auto right = sum_of_zeros == Real(0);
    for (std::size_t i = 0; i < kRows; ++i) {
      const Real u =
          select(right, forward[i] - row_times<Real>(gain_.or_constants(kGain), i, x), Real(0));
      put(out.u, i, eagerx::clamp(u, each<Real>(kLow, i), each<Real>(kHigh, i)));
    }
  }

 private:
  using Real = typename Io::Real;
  static constexpr std::size_t kRows = elements_of<decltype(Io::Outputs::u)>;
  static constexpr auto kGain = constants<Real>(Io::Config::gain);
  static constexpr auto kReferenceGain = constants<Real>(Io::Config::reference_gain);
  static constexpr auto kLow = constants<Real>(Io::Config::low);
  static constexpr auto kHigh = constants<Real>(Io::Config::high);
  static_assert(is_one_or_each(kLow, kRows) && is_one_or_each(kHigh, kRows),
                "StateFeedback: `low` and `high` have one value, or one for each row");
  static_assert(in_order(Io::Config::low, Io::Config::high),
                "StateFeedback: `low` is not above `high`");

  template <class Window>
  static auto numbers(const Window& window, Real& sum_of_zeros) {
    const Real nan(FloatFormat<LaneOf<Real>>::nan);
    std::array<Real, elements_of<Window>> x;
    for (std::size_t i = 0; i < x.size(); ++i) {
      x[i] = newest<Real>(window, i, nan);
      sum_of_zeros += Real(0) * x[i];
    }
    return x;
  }

  using States = typename Io::States;
  static constexpr bool kTunesGain = requires(States s) { s.gain; };
  static constexpr bool kTunesReferenceGain = requires(States s) { s.reference_gain; };
  [[no_unique_address]] TunableList<Real, kGain.size(), kTunesGain, 0> gain_{};
  [[no_unique_address]] TunableList<Real, kReferenceGain.size(), kTunesReferenceGain, 1>
      reference_gain_{};
};

}  // namespace eagerx::models
