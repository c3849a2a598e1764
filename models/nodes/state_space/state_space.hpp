// A linear system in discrete time.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/rate.hpp>
#include <models/nodes/action_limits/per_element.hpp>
#include <models/nodes/block.hpp>
#include <models/nodes/observer/linear_states.hpp>

namespace eagerx::models {

/// y = C·x + D·u, then x := A·x + B·u, with u the signal. The last finite signal takes the place of
/// one that is not finite; before the first it is 0. An x that overflows begins anew.
template <class Io>
class StateSpace {
 public:
  void reset(const typename Io::States& states) {
    held_ = {};
    begin();
    if constexpr (requires { states.x; }) {
      for (std::size_t i = 0; states.x && i < kOrder; ++i)
        x_.set(i, static_cast<Real>(element(*states.x, i)));
    }
  }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    std::array<Real, kInputs> u;
    for (std::size_t i = 0; i < kInputs; ++i) {
      u[i] = held_[i](newest<Real>(in.signal, i, held_[i].last));
    }
    const auto x = x_.values();
    for (std::size_t i = 0; i < kOutputs; ++i) {
      Real y = row_times<Real>(kC, i, x);
      if constexpr (kD.size() == kOutputs * kInputs) y += row_times<Real>(kD, i, u);
      put(out.y, i, y);
    }
    std::array<Real, kOrder> drive;
    for (std::size_t i = 0; i < kOrder; ++i) drive[i] = row_times<Real>(kB, i, u);
    x_.advance(Io::Config::a, kIncrements, drive);
    change_where<Real>(!x_.is_finite(), x_, [&] { begin(); });
  }

 private:
  using Real = typename Io::Real;

  void begin() {
    for (std::size_t i = 0; i < kOrder; ++i) x_.set(i, each<Real>(kInitial, i));
  }

  static constexpr auto kOrder = static_cast<std::size_t>(Io::Config::order);
  static constexpr std::size_t kInputs = elements_of<decltype(Io::Inputs::signal)>;
  static constexpr std::size_t kOutputs = elements_of<decltype(Io::Outputs::y)>;
  static constexpr auto kA = constants<Real>(Io::Config::a);
  static constexpr auto kIncrements = constants<Real>(increments_of<kOrder>(Io::Config::a));
  static constexpr auto kB = constants<Real>(Io::Config::b);
  static constexpr auto kC = constants<Real>(Io::Config::c);
  static constexpr auto kD = constants<Real>(Io::Config::d);
  static constexpr auto kInitial = constants<Real>(Io::Config::initial);
  static_assert(kA.size() == kOrder * kOrder, "StateSpace: `a` has order x order values");
  static_assert(kB.size() == kOrder * kInputs,
                "StateSpace: `b` has `order` times as many values as the signal has elements");
  static_assert(kC.size() == kOutputs * kOrder,
                "StateSpace: `c` has `outputs` times `order` values");
  static_assert(kD.size() == kOutputs * kInputs || (kD.size() == 1 && Io::Config::d[0] == 0.0),
                "StateSpace: `d` has a value for each output and input, or is 0");
  static_assert(is_one_or_each(kInitial, kOrder),
                "StateSpace: `initial` has one value, or one for each state");

  LinearStates<Real, kOrder> x_{};
  std::array<Held<Real>, kInputs> held_{};
};

}  // namespace eagerx::models
