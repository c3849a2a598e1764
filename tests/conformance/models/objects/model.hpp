// An object of one integer with three actuators.
#pragma once

#include <cstddef>

namespace oracle {

template <class Io>
struct OModel {
  static constexpr std::size_t kActuators = 3;
};

}  // namespace oracle
