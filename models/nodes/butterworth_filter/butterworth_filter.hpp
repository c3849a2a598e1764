// A recursive Butterworth filter whose coefficients are computed by the compiler.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <models/nodes/block.hpp>
#include <models/nodes/butterworth_filter/butterworth_design.hpp>
#include <models/nodes/butterworth_filter/filter_start.hpp>
#include <models/nodes/butterworth_filter/state_section.hpp>
#include <type_traits>

namespace eagerx::models {

/// The filter's coefficients, from its configuration and the rate of its node.
template <class Io>
class ButterworthSections {
 public:
  using Real = typename Io::Real;
  using Config = typename Io::Config;
  using Lane = LaneOf<Real>;
  struct Section {
    Lane b0, b1, b2, a1, a2;
    Lane gain;  // of a constant
  };

  /// Whether a corner is so low that the coefficients of a section nearly cancel: a1 is then near
  /// −2 and a2 near 1, and only their difference matters.
  static constexpr bool kIsLow = Config::cutoff_hz[0] < Io::Rate::hz / 50.0;

  /// [number of sections]
  static constexpr auto design() {
    constexpr Sections kExact = exact();
    std::array<Section, kExact.count> sections{};
    for (std::size_t i = 0; i < kExact.count; ++i) {
      const SecondOrderSection& s = kExact.sections[i];
      sections[i] = {rounded(s.b0), rounded(s.b1), rounded(s.b2),
                     rounded(s.a1), rounded(s.a2), Lane(0)};
      sections[i].gain = gain_of(sections[i]);
    }
    return sections;
  }

  /// The same sections as integrators, each with its share of the gain. [number of sections]
  static constexpr auto design_states() {
    constexpr Sections kExact = exact();
    std::array<StateSection<Real>, kExact.count> sections{};
    const double gain = root_of(kExact.sections[0].b0, static_cast<int>(kExact.count));
    for (std::size_t i = 0; i < kExact.count; ++i)
      sections[i] = state_section<Real>(kExact.sections[i], gain);
    return sections;
  }

 private:
  static constexpr Lane rounded(double x) { return static_cast<Lane>(x); }
  /// Of the rounded coefficients, so that nothing creeps.
  static constexpr Lane gain_of(const Section& s) {
    const auto sum = [](Lane x, Lane y, Lane z) {
      return (static_cast<double>(x) + static_cast<double>(y)) + static_cast<double>(z);
    };
    return rounded(sum(s.b0, s.b1, s.b2) / sum(Lane(1), s.a1, s.a2));
  }
  static constexpr Sections exact() {
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
    return design_butterworth(kOrder, Config::type, kLow, kHigh, Io::Rate::hz);
  }
};

/// Filters every element of `signal` (shape [] or [n]) at the rate of the node, one sample a tick,
/// in second-order sections (direct form II transposed):
///   y = b0·x + z1,  z1 ← b1·x − a1·y + z2,  z2 ← b2·x − a2·y
/// and where a corner is below a fiftieth of the rate as integrators (state_section.hpp). Starts
/// from rest: the past of the signal is zero at a reset, or with `initial: measured` the first
/// sample of each element. Until a signal arrives (skipped connections), the sample is zero. A
/// sample that is not finite passes, and leaves the memory unchanged.
template <class Io>
class ButterworthFilter {
 public:
  void reset(const typename Io::States& /*states*/) {
    memory_ = {};
    start_.reset();
  }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    const Message signal = in.signal.back_or(Message{});
    for (std::size_t i = 0; i < kElements; ++i) {
      const auto sample = static_cast<Real>(element(signal, i));
      Real filtered = sample;
      change_where<Real>(start_.begins(i, in.signal.empty(), sample), memory_[i],
                         [&] { settle(sample, memory_[i]); });
      change_where<Real>(eagerx::isfinite(sample), memory_[i],
                         [&] { filtered = filter(sample, memory_[i]); });
      // Resets the state of an element that overflowed.
      const TruthOf<Real> lost = eagerx::isfinite(sample) && !eagerx::isfinite(filtered);
      change_where<Real>(lost, memory_[i], [&] { memory_[i] = {}; });
      start_.forget(i, lost);
      element(out.filtered, i) =
          static_cast<ScalarOf<Message>>(select(eagerx::isfinite(sample), filtered, sample));
    }
  }

 private:
  using Real = typename Io::Real;
  using Message = typename decltype(Io::Inputs::signal)::value_type;
  using Sections = ButterworthSections<Io>;
  static constexpr std::size_t kElements = size_of<Message>;
  static constexpr auto kSections = [] {
    if constexpr (Sections::kIsLow) {
      return Sections::design_states();
    } else {
      return Sections::design();
    }
  }();

  struct DirectMemory {
    Real z1, z2;
  };
  using Memory = std::conditional_t<Sections::kIsLow, StateMemory<Real>, DirectMemory>;
  using Memories = std::array<Memory, kSections.size()>;

  static constexpr Real filter(Real sample, Memories& memories) {
    for (std::size_t i = 0; i < kSections.size(); ++i)
      sample = pass(sample, kSections[i], memories[i]);
    return sample;
  }
  static constexpr Real pass(Real x, const typename Sections::Section& s, DirectMemory& z) {
    const Real y = Real(s.b0) * x + z.z1;
    z.z1 = Real(s.b1) * x - Real(s.a1) * y + z.z2;
    z.z2 = Real(s.b2) * x - Real(s.a2) * y;
    return y;
  }
  static constexpr Real pass(Real x, const StateSection<Real>& s, StateMemory<Real>& z) {
    return s.pass(x, z);
  }

  /// The memory after a signal that has always been `sample`.
  static constexpr void settle(Real sample, Memories& memories) {
    for (std::size_t i = 0; i < kSections.size(); ++i)
      sample = rest_at(sample, kSections[i], memories[i]);
  }
  /// y
  static constexpr Real rest_at(Real x, const typename Sections::Section& s, DirectMemory& z) {
    const Real y = Real(s.gain) * x;
    z.z2 = Real(s.b2) * x - Real(s.a2) * y;
    z.z1 = (Real(s.b1) * x - Real(s.a1) * y) + z.z2;
    return y;
  }
  static constexpr Real rest_at(Real x, const StateSection<Real>& s, StateMemory<Real>& z) {
    z.first.set(Real(0));
    z.second.set(x);
    return (Real(s.m0) + Real(s.m2)) * x;
  }

  std::array<Memories, kElements> memory_{};
  [[no_unique_address]] FilterStart<Real, kElements, Io::Config::initial> start_{};
};

}  // namespace eagerx::models
