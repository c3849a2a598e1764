// The Butterworth filter of EAGERx's tests: a finite part of the filter's response.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <models/nodes/block.hpp>
#include <models/nodes/butterworth_filter/butterworth_design.hpp>

namespace eagerx::models {

/// filtered[0] := the last of the last N samples of element `index` after a Butterworth filter of
/// order N that begins at rest with the first of them; with fewer samples, the last one; without
/// any (skipped connections), zero.
/// Source: eagerx, tests/test/butterworth_filter.py.
template <class Io>
class WindowedButterworth {
 public:
  void reset(const typename Io::States& /*states*/) {}

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    static_assert(decltype(Io::Inputs::signal)::kMaxSize >= kOrder,
                  "WindowedButterworth: the window of `signal` must be at least `N`");
    const auto size = in.signal.size();
    Real filtered{};
    if constexpr (lanes<Real> == 1) {
      if (size >= kOrder) {
        filtered = filter(in.signal, size - kOrder);
      } else if (size > 0) {
        filtered = sample(in.signal, size - 1);
      }
    } else {
      constexpr std::uint32_t kMost = decltype(Io::Inputs::signal)::kMaxSize;
      const CountOf<Real> there(size);
      filtered = select(there > CountOf<Real>(0U), sample(in.signal, kMost - 1), Real(0));
      filtered =
          select(there >= CountOf<Real>(kOrder), filter(in.signal, kMost - kOrder), filtered);
    }
    put(out.filtered, 0, filtered);
  }

 private:
  using Real = typename Io::Real;
  using Config = typename Io::Config;
  using Message = typename decltype(Io::Inputs::signal)::value_type;
  static constexpr auto kOrder = static_cast<std::uint32_t>(Config::N);
  static constexpr auto kIndex = static_cast<std::size_t>(Config::index);
  static_assert(kIndex < size_of<Message>,
                "WindowedButterworth: `index` is beyond the end of `signal`");
  static_assert(Config::N >= 1 && Config::N <= kMaxButterworthOrder,
                "WindowedButterworth: `N` must be 1 to 8");
  static_assert(Config::Wn.size() == (is_band(Config::btype) ? 2 : 1),
                "WindowedButterworth: `Wn` must be one frequency for lowpass and highpass, and two "
                "for bandpass and bandstop");
  static constexpr double kLow = Config::Wn[0];
  static constexpr double kHigh = Config::Wn[Config::Wn.size() - 1];
  static_assert(kLow > 0.0 && kHigh < Io::Rate::hz / 2.0,
                "WindowedButterworth: every frequency in `Wn` must be above 0 and below half the "
                "rate of the node");
  static_assert(!is_band(Config::btype) || kLow < kHigh,
                "WindowedButterworth: the first frequency in `Wn` must be below the second");
  static constexpr Sections kSections =
      design_butterworth(Config::N, Config::btype, kLow, kHigh, Io::Rate::hz);

  template <class Window>
  static Real sample(const Window& signal, std::uint32_t i) {
    return static_cast<Real>(element(signal[i], kIndex));
  }

  /// Second-order sections in direct form II transposed, as scipy.signal.sosfilt has them.
  template <class Window>
  static Real filter(const Window& signal, std::uint32_t first) {
    std::array<std::array<Real, 2>, kSections.count> memory{};
    Real y{};
    for (std::uint32_t i = 0; i < kOrder; ++i) {
      y = sample(signal, first + i);
      for (std::size_t s = 0; s < kSections.count; ++s) {
        const SecondOrderSection& section = kSections.sections[s];
        auto& [z1, z2] = memory[s];
        const Real x = y;
        y = static_cast<Real>(section.b0) * x + z1;
        z1 = static_cast<Real>(section.b1) * x - static_cast<Real>(section.a1) * y + z2;
        z2 = static_cast<Real>(section.b2) * x - static_cast<Real>(section.a2) * y;
      }
    }
    return y;
  }
};

}  // namespace eagerx::models
