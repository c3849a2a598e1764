// What tests of trainings share.
#pragma once

#include "targets/environments/train/client.hpp"

namespace eagerx::train {

inline const Interrupt never = false;

/// The library that is written by hand, pendulum_library.cpp.
inline const Library& pendulum() {
  static const Library library(EAGERX_TEST_PENDULUM);
  return library;
}

}  // namespace eagerx::train
