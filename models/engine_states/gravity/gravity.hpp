// Sets the gravity of OpenDynamicsEngine.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>

namespace eagerx::models {

/// At a reset: gravity [m/s²] := value [3], or -value [] along z.
template <class Io>
struct Gravity {
  static void reset(const typename Io::State& value, typename Io::Simulator& simulator) {
    constexpr std::size_t kSize = size_of<typename Io::State>;
    static_assert(kSize == 1 || kSize == 3, "Gravity: the state has one value or three");
    if constexpr (kSize == 1) {
      simulator.set_gravity({{0.0, 0.0, -static_cast<double>(element(value, 0))}});
    } else {
      simulator.set_gravity(
          {{static_cast<double>(element(value, 0)), static_cast<double>(element(value, 1)),
            static_cast<double>(element(value, 2))}});
    }
  }
};

}  // namespace eagerx::models
