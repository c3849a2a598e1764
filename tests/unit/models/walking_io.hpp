// Io structs of the nodes of walking robots, as the generator emits them.
#pragma once

#include <optional>

#include "tests/unit/models/io.hpp"

namespace eagerx::models::testing {

template <class RealType>
struct WalkingIo {
  using Real = RealType;
  using Rate = eagerx::Rate<10>;
};

template <class Real>
struct WalkingCommandsIo : WalkingIo<Real> {
  struct Config {
    static constexpr double standing = 0.1;
  };
  struct Inputs {};
  struct Outputs {
    Array<float, 3>& command;
  };
  struct States {
    std::optional<Array<float, 12>> speeds;
    std::optional<Array<float, 4>> durations, stand;
  };
};

template <class Real>
struct PushesIo : WalkingIo<Real> {
  struct Config {
    static constexpr double duration = 0.2;
  };
  struct Inputs {};
  struct Outputs {
    Array<float, 3>& force;
  };
  struct States {
    std::optional<Array<float, 6>> impulses;
    std::optional<Array<float, 3>> waits;
  };
};

template <class Real>
struct BodyMotionIo : WalkingIo<Real> {
  using Config = NoConfig;
  using States = NoStates;
  struct Inputs {
    Skipped<Array<float, 7>> pose;
    Skipped<Array<float, 6>> twist;
  };
  struct Outputs {
    Array<float, 3>&velocity, &angular_velocity, &gravity;
  };
};

template <class Real>
struct SpeedErrorsIo : WalkingIo<Real> {
  struct Config {
    static constexpr double window = 0.3;
  };
  using States = NoStates;
  struct Inputs {
    Skipped<Array<float, 3>> velocity, angular_velocity, command;
  };
  struct Outputs {
    float &speed, &turn, &instant;
  };
};

}  // namespace eagerx::models::testing
