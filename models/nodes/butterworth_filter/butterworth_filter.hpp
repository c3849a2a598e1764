// A recursive Butterworth filter whose coefficients are computed by the compiler.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <models/nodes/butterworth_filter/butterworth_design.hpp>

namespace eagerx::models {

/// The filter's coefficients, from its configuration and the rate of its node.
template <class Io>
class ButterworthSections {
 public:
  using Real = typename Io::Real;
  struct Section {
    Real b0, b1, b2, a1, a2;
  };

  /// [number of sections]
  static constexpr auto design() {
    using Config = typename Io::Config;
    constexpr auto kOrder = static_cast<int>(Config::order);
    constexpr bool kBand = is_band(Config::type);
    constexpr std::size_t kCorners = kBand ? 2 : 1;
    static_assert(kOrder >= 1 && kOrder <= kMaxButterworthOrder,
                  "ButterworthFilter: `order` must be 1 to 8");
    static_assert(Config::cutoff_hz.size() == kCorners,
                  "ButterworthFilter: `cutoff_hz` must be one frequency for lowpass and highpass, "
                  "and two for bandpass and bandstop");
    constexpr double kLow = Config::cutoff_hz[0];
    constexpr double kHigh = Config::cutoff_hz[kCorners - 1];
    static_assert(kLow > 0.0 && kHigh < Io::Rate::hz / 2.0,
                  "ButterworthFilter: every frequency in `cutoff_hz` must be above 0 and below "
                  "half the rate of the node");
    static_assert(!kBand || kLow < kHigh,
                  "ButterworthFilter: the first frequency in `cutoff_hz` must be below the second");

    constexpr Sections kExact = design_butterworth(kOrder, Config::type, kLow, kHigh, Io::Rate::hz);
    std::array<Section, kExact.count> sections{};
    for (std::size_t i = 0; i < kExact.count; ++i) {
      const SecondOrderSection& s = kExact.sections[i];
      sections[i] = {static_cast<Real>(s.b0), static_cast<Real>(s.b1), static_cast<Real>(s.b2),
                     static_cast<Real>(s.a1), static_cast<Real>(s.a2)};
    }
    return sections;
  }
};

/// Filters every element of `signal` (shape [] or [n]) at the rate of the node, one sample a tick,
/// in second-order sections (direct form II transposed):
///   y = b0·x + z1,  z1 ← b1·x − a1·y + z2,  z2 ← b2·x − a2·y
/// Starts from rest: the past of the signal is zero at a reset. As long as no signal has come
/// (skipped connections), the sample is zero. NaN and infinity stay until the next reset.
template <class Io>
class ButterworthFilter {
 public:
  void reset(const typename Io::States& /*states*/) { memory_ = {}; }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    const Message signal = in.signal.back_or(Message{});
    for (std::size_t i = 0; i < kElements; ++i) {
      const auto sample = static_cast<Real>(element(signal, i));
      element(out.filtered, i) = static_cast<ScalarOf<Message>>(filter(sample, memory_[i]));
    }
  }

 private:
  using Real = typename Io::Real;
  using Message = typename decltype(Io::Inputs::signal)::value_type;
  static constexpr std::size_t kElements = size_of<Message>;
  static constexpr auto kSections = ButterworthSections<Io>::design();

  struct Memory {
    Real z1, z2;
  };
  using Memories = std::array<Memory, kSections.size()>;

  static constexpr Real filter(Real sample, Memories& memories) {
    for (std::size_t i = 0; i < kSections.size(); ++i) {
      const auto& s = kSections[i];
      Memory& z = memories[i];
      const Real y = s.b0 * sample + z.z1;
      z.z1 = s.b1 * sample - s.a1 * y + z.z2;
      z.z2 = s.b2 * sample - s.a2 * y;
      sample = y;
    }
    return sample;
  }

  std::array<Memories, kElements> memory_{};
};

}  // namespace eagerx::models
