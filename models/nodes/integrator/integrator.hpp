// The integral of a signal, within limits.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <eagerx/rate.hpp>
#include <models/nodes/action_limits/per_element.hpp>
#include <models/nodes/block.hpp>

namespace eagerx::models {

enum class IntegrationMethod : std::uint8_t { forward, backward, trapezoidal };

/// With x the signal and T the period, element by element:
///   forward      y[n] = s[n − 1], s[n] = clamp(s[n − 1] + T·x[n])
///   backward     y[n] = clamp(y[n − 1] + T·x[n])
///   trapezoidal  y[n] = clamp(y[n − 1] + T/2·(x[n] + x[n − 1]))
/// The state itself is limited, so nothing winds up. A signal that is not finite, is missing or
/// makes the sum overflow adds nothing.
template <class Io>
class Integrator {
 public:
  void reset(const typename Io::States& states) {
    for (std::size_t i = 0; i < kSize; ++i) {
      Real value = each<Real>(kInitial, i);
      if constexpr (requires { states.value; }) {
        if (states.value) {
          value = static_cast<Real>(element(*states.value, kInitial.size() == 1 ? 0 : i));
        }
      }
      value_[i].set(eagerx::clamp(value, each<Real>(kLow, i), each<Real>(kHigh, i)));
      last_[i] = Real(0);
    }
  }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    for (std::size_t i = 0; i < kSize; ++i) {
      const Real signal = newest<Real>(in.signal, i);
      const Real x = select(eagerx::isfinite(signal), signal, Real(0));
      const Real before = value_[i].value;
      if constexpr (kMethod == IntegrationMethod::trapezoidal) {
        add(i, Real(kHalf) * (x + last_[i]));
        last_[i] = x;
      } else {
        add(i, Real(kPeriod) * x);
      }
      put(out.y, i, kMethod == IntegrationMethod::forward ? before : value_[i].value);
    }
  }

 private:
  using Real = typename Io::Real;
  static constexpr std::size_t kSize = elements_of<decltype(Io::Outputs::y)>;
  static constexpr auto kMethod = Io::Config::method;
  static constexpr auto kPeriod = constant<Real>(Io::Rate::period_s);
  static constexpr auto kHalf = constant<Real>(Io::Rate::period_s / 2.0);
  static constexpr auto kInitial = constants<Real>(Io::Config::initial);
  static constexpr auto kLow = constants<Real>(Io::Config::low);
  static constexpr auto kHigh = constants<Real>(Io::Config::high);
  static_assert(is_one_or_each(kInitial, kSize) && is_one_or_each(kLow, kSize) &&
                    is_one_or_each(kHigh, kSize),
                "Integrator: `initial`, `low` and `high` have one value, or one for each element");
  static_assert(in_order(Io::Config::low, Io::Config::high),
                "Integrator: `low` is not above `high`");

  void add(std::size_t i, const Real& x) {
    const auto sum = value_[i].plus(x);
    const auto limited = sum.within(each<Real>(kLow, i), each<Real>(kHigh, i));
    const auto good = eagerx::isfinite(sum.value);
    value_[i] = {select(good, limited.value, value_[i].value),
                 select(good, limited.rest, value_[i].rest)};
  }

  std::array<CompensatedSum<Real>, kSize> value_{};
  std::array<Real, kSize> last_{};  // trapezoidal: the signal a tick ago
};

}  // namespace eagerx::models
