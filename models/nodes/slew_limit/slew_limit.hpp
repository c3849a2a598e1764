// Limits the rate of change of a signal.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <models/nodes/action_limits/per_element.hpp>
#include <models/nodes/block.hpp>
#include <type_traits>

namespace eagerx::models {

/// Every tick, for each element: y ← y + clamp(x − y, ±per_second/rate), x the last `signal`,
/// y = `initial` at a reset; `limited` is y. NaN and a signal that is missing leave y as it is.
template <class Io>
class SlewLimit {
 public:
  void reset(const typename Io::States& states) {
    for (std::size_t i = 0; i < kSize; ++i) value_[i].set(value_for<Real>(Io::Config::initial, i));
    tune(states);
  }
  void tune([[maybe_unused]] const typename Io::States& states) {
    if constexpr (requires { states.per_second; }) per_second_.reset(states.per_second, kPerSecond);
  }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    using Result = std::remove_cvref_t<decltype(out.limited)>;
    static_assert(size_of<Result> == kSize,
                  "SlewLimit: `limited` must have as many elements as `signal`");
    TruthOf<Real> limited = false;
    for (std::size_t i = 0; i < kSize; ++i) {
      // A missing message, like NaN, leaves the value unchanged.
      const Real wanted = newest<Real>(in.signal, i, Real(FloatFormat<LaneOf<Real>>::nan));
      const TruthOf<Real> lags = follow(i, wanted);
      limited = limited || (lags && !in.signal.empty());
      element(out.limited, i) = static_cast<ScalarOf<Result>>(value_[i].value);
    }
    limited_ += one_if<Real>(limited);
  }

  /// Calls f(name, count) for each count; counts continue over episodes.
  template <class F>
  void for_each_count(F&& f) const {
    f("limited", limited_);
  }

 private:
  using Real = typename Io::Real;
  using Message = typename decltype(Io::Inputs::signal)::value_type;
  static constexpr std::size_t kSize = size_of<Message>;
  static constexpr auto kPerSecond = constants<Real>(Io::Config::per_second);
  static_assert(is_one_or_each(Io::Config::per_second, kSize) &&
                    is_one_or_each(Io::Config::initial, kSize),
                "SlewLimit: `per_second` and `initial` have one value, or one for each element");

  /// True if element `i` could not follow. A signal within reach is taken as it is, to the bit.
  TruthOf<Real> follow(std::size_t i, Real wanted) {
    const Real step =
        each<Real>(per_second_.or_constants(kPerSecond), i) * static_cast<Real>(Io::Rate::period_s);
    const auto up = value_[i].plus(step);
    const auto down = value_[i].plus(-step);
    const TruthOf<Real> rises = wanted > up.value;
    const TruthOf<Real> falls = wanted < down.value;
    const TruthOf<Real> within = !(rises || falls || eagerx::isnan(wanted));
    const auto choose = [&](const Real& u, const Real& d, const Real& there, const Real& w) {
      return select(within, w, select(rises, u, select(falls, d, there)));
    };
    value_[i] = {choose(up.value, down.value, value_[i].value, wanted),
                 choose(up.rest, down.rest, value_[i].rest, Real(0))};
    return !within;
  }

  std::array<CompensatedSum<Real>, kSize> value_{};
  CountOf<Real> limited_{};

  using States = typename Io::States;
  static constexpr bool kTunesPerSecond = requires(States s) { s.per_second; };
  [[no_unique_address]] TunableList<Real, kPerSecond.size(), kTunesPerSecond, 0> per_second_{};
};

}  // namespace eagerx::models
