// A matrix times a signal.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/rate.hpp>
#include <models/nodes/block.hpp>

namespace eagerx::models {

/// y [rows] = gain [rows][columns] · signal [columns], each row added from left to right. Zero
/// before the first signal; NaN passes.
template <class Io>
class MatrixGain {
 public:
  void reset(const typename Io::States& states) { tune(states); }
  void tune([[maybe_unused]] const typename Io::States& states) {
    if constexpr (requires { states.gain; }) gain_.reset(states.gain, kGain);
  }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    constexpr std::size_t kColumns = elements_of<decltype(in.signal)>;
    constexpr std::size_t kRows = elements_of<decltype(out.y)>;
    static_assert(kGain.size() == kRows * kColumns,
                  "MatrixGain: `gain` has `rows` times as many values as `signal` has elements");
    std::array<Real, kColumns> x;
    for (std::size_t i = 0; i < kColumns; ++i) x[i] = newest<Real>(in.signal, i);
    for (std::size_t row = 0; row < kRows; ++row)
      put(out.y, row, row_times<Real>(gain_.or_constants(kGain), row, x));
  }

 private:
  using Real = typename Io::Real;
  static constexpr auto kGain = constants<Real>(Io::Config::gain);

  using States = typename Io::States;
  static constexpr bool kTunesGain = requires(States s) { s.gain; };
  [[no_unique_address]] TunableList<Real, kGain.size(), kTunesGain, 0> gain_{};
};

}  // namespace eagerx::models
