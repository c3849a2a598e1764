// An object of two integers with two actuators.
#pragma once

#include <cstddef>

namespace oracle {

template <class Io>
struct M2Model {
  static constexpr std::size_t kActuators = 2;
};

}  // namespace oracle
