// The linear model that Observer and KalmanFilter predict with.
#pragma once

#include <array>
#include <cstddef>
#include <models/nodes/action_limits/per_element.hpp>
#include <models/nodes/block.hpp>
#include <models/nodes/observer/linear_states.hpp>

namespace eagerx::models {

/// x := A·x + B·u, y = C·x. Inputs: `measured` and, where there is one, `u`.
template <class Io>
struct LinearModel {
  using Real = typename Io::Real;
  using Inputs = typename Io::Inputs;
  static constexpr auto kOrder = static_cast<std::size_t>(Io::Config::order);
  static constexpr std::size_t kMeasured = elements_of<decltype(Inputs::measured)>;
  static constexpr auto kA = constants<Real>(Io::Config::a);
  static constexpr auto kIncrements = constants<Real>(increments_of<kOrder>(Io::Config::a));
  static constexpr auto kB = constants<Real>(Io::Config::b);
  static constexpr auto kC = constants<Real>(Io::Config::c);
  static constexpr auto kInitial = constants<Real>(Io::Config::initial);
  static_assert(kA.size() == kOrder * kOrder, "`a` has order x order values");
  static_assert(kC.size() == kOrder * kMeasured,
                "`c` has `order` times as many values as `measured` has elements");
  static_assert(is_one_or_each(kInitial, kOrder), "`initial` has one value, or one for each state");

  template <class States>
  void reset(const States& states) {
    begin();
    if constexpr (requires { states.x; }) {
      for (std::size_t i = 0; states.x && i < kOrder; ++i)
        x.set(i, static_cast<Real>(element(*states.x, i)));
    }
  }
  void begin() {
    for (std::size_t i = 0; i < kOrder; ++i) x.set(i, each<Real>(kInitial, i));
  }

  /// A u that is not finite or is missing counts as 0.
  void predict(const Inputs& in) {
    std::array<Real, kOrder> drive{};
    if constexpr (requires { in.u; }) {
      std::array<Real, elements_of<decltype(in.u)>> u;
      static_assert(kB.size() == kOrder * u.size(),
                    "`b` has `order` times as many values as `u` has elements");
      for (std::size_t i = 0; i < u.size(); ++i) {
        const Real input = newest<Real>(in.u, i);
        u[i] = select(eagerx::isfinite(input), input, Real(0));
      }
      for (std::size_t i = 0; i < kOrder; ++i) drive[i] = row_times<Real>(kB, i, u);
    }
    x.advance(Io::Config::a, kIncrements, drive);
  }

  /// Whether element `i` of measured is there and finite.
  static auto is_measured(const Inputs& in, std::size_t i) {
    const Real nan(FloatFormat<LaneOf<Real>>::nan);
    return eagerx::isfinite(newest<Real>(in.measured, i, nan));
  }
  /// measured − C·x of element `i`; 0 where nothing is measured.
  Real innovation(const Inputs& in, std::size_t i) const {
    const Real difference = newest<Real>(in.measured, i) - row_times<Real>(kC, i, x.values());
    return select(is_measured(in, i), difference, Real(0));
  }

  LinearStates<Real, kOrder> x{};
};

}  // namespace eagerx::models
