// The difference of two signals.
#pragma once

#include <cstddef>
#include <eagerx/rate.hpp>
#include <models/nodes/block.hpp>

namespace eagerx::models {

/// y = plus − minus, element by element, moved by whole turns into [−turn/2, turn/2] if `turn` is
/// above 0. An input without a message counts as zero; NaN passes.
template <class Io>
class Difference {
 public:
  void reset(const typename Io::States& /*states*/) {}

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    static_assert(elements_of<decltype(in.plus)> == elements_of<decltype(in.minus)>,
                  "Difference: `plus` and `minus` have the same number of elements");
    constexpr auto kTurn = constant<Real>(Io::Config::turn);
    for (std::size_t i = 0; i < elements_of<decltype(out.y)>; ++i) {
      const Real difference = newest<Real>(in.plus, i) - newest<Real>(in.minus, i);
      put(out.y, i, within_turn(difference, kTurn));
    }
  }

 private:
  using Real = typename Io::Real;
};

}  // namespace eagerx::models
