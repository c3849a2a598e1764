// One of two signals, selected by a third one.
#pragma once

#include <cstddef>
#include <eagerx/rate.hpp>
#include <models/nodes/block.hpp>

namespace eagerx::models {

/// y = a where control ≥ threshold, else b: also if control is NaN or missing. `control` is
/// one number for all elements, or one for each. An input without a message counts as zero.
template <class Io>
class Switch {
 public:
  void reset(const typename Io::States& /*states*/) {}

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    constexpr std::size_t kSize = elements_of<decltype(out.y)>;
    constexpr std::size_t kControls = elements_of<decltype(in.control)>;
    static_assert(elements_of<decltype(in.a)> == kSize && elements_of<decltype(in.b)> == kSize,
                  "Switch: `a` and `b` have the same number of elements");
    static_assert(kControls == 1 || kControls == kSize,
                  "Switch: `control` has one element, or as many as `a`");
    const Real threshold(constant<Real>(Io::Config::threshold));
    for (std::size_t i = 0; i < kSize; ++i) {
      const Real nan(FloatFormat<LaneOf<Real>>::nan);
      const Real control = newest<Real>(in.control, kControls == 1 ? 0 : i, nan);
      put(out.y, i, select(control >= threshold, newest<Real>(in.a, i), newest<Real>(in.b, i)));
    }
  }

 private:
  using Real = typename Io::Real;
};

}  // namespace eagerx::models
