// The torque of a DC motor from its voltage.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>

namespace eagerx::models {

/// Every element u [V] becomes −u·K/R [N·m].
/// Source: eagerx_tutorials, pendulum/processor.py.
template <class Io>
struct VoltageToMotorTorque {
  static typename Io::Output convert(const typename Io::Input& in) {
    using Scalar = ScalarOf<typename Io::Output>;
    using Real = typename Io::Real;
    static_assert(Io::Config::R != 0.0, "VoltageToMotorTorque: `R` must not be 0");
    typename Io::Output out{};
    for (std::size_t i = 0; i < size_of<typename Io::Input>; ++i) {
      const Real scaled = -static_cast<Real>(element(in, i)) * static_cast<Real>(Io::Config::K);
      element(out, i) = static_cast<Scalar>(scaled / static_cast<Real>(Io::Config::R));
    }
    return out;
  }
};

}  // namespace eagerx::models
