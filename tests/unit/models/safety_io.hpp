// Io structs of the safety layers, as the generator emits them.
#pragma once

#include "tests/unit/models/io.hpp"

namespace eagerx::models::testing {

template <class RealType>
struct LayerIo {
  using Real = RealType;
  using Rate = eagerx::Rate<10>;
  using States = NoStates;
};

template <class Real, class Message>
struct ActionLimitsIo : LayerIo<Real> {
  struct Config {
    static constexpr std::array<double, 1> low = {-2.0};
    static constexpr std::array<double, 1> high = {3.0};
  };
  struct Inputs {
    Skipped<Message> action;
  };
  struct Outputs {
    Message& limited;
  };
};

template <class Real, class Message>
struct SlewLimitIo : LayerIo<Real> {
  struct Config {
    static constexpr std::array<double, 1> per_second = {5.0};  // 0.5 a tick
    static constexpr std::array<double, 1> initial = {0.25};
  };
  struct Inputs {
    Skipped<Message> signal;
  };
  struct Outputs {
    Message& limited;
  };
};

template <class Real, class Message>
struct NanGuardIo : LayerIo<Real> {
  struct Config {
    static constexpr std::array<double, 1> safe = {0.5};
    static constexpr int hold = 2;
  };
  struct Inputs {
    Skipped<Message> signal;
  };
  struct Outputs {
    Message& guarded;
  };
};

struct FallbackConfig {
  static constexpr std::array<double, 1> low = {-10.0};
  static constexpr std::array<double, 1> high = {10.0};
  static constexpr std::array<double, 1> margin = {2.0};
  static constexpr int stale = 2;
  static constexpr int bad = 2;
  static constexpr int good = 3;
  static constexpr std::array<double, 1> safe = {0.5};
};
template <class Real, class Message>
struct FallbackIo : LayerIo<Real> {
  using Config = FallbackConfig;
  struct Inputs {
    Skipped<Message> primary;
    Skipped<Message> fallback;
    Skipped<float> watched;
  };
  struct Outputs {
    Message& chosen;
    bool& active;
  };
};
/// Without what may be left out.
template <class Real, class Message>
struct PlainFallbackIo : LayerIo<Real> {
  struct Config : FallbackConfig {
    static constexpr int stale = 0;
    static constexpr int bad = 1;
    static constexpr int good = 0;
  };
  struct Inputs {
    Skipped<Message> primary;
    Skipped<Message> fallback;
  };
  struct Outputs {
    Message& chosen;
  };
};

struct PidConfig {
  static constexpr double kp = 2.0;
  static constexpr double ki = 0.0;
  static constexpr double kd = 0.0;
  static constexpr double setpoint = 0.0;
  static constexpr double turn = 0.0;
  static constexpr double low = -4.0;
  static constexpr double high = 4.0;
};
template <class Real, class ConfigType = PidConfig>
struct PidIo : LayerIo<Real> {
  using Config = ConfigType;
  struct Inputs {
    Skipped<float> measured;
  };
  struct Outputs {
    Array<float, 1>& u;
  };
};
template <class Real, class ConfigType = PidConfig>
struct StateFeedbackIo : PidIo<Real, ConfigType> {
  struct Inputs {
    Skipped<float> measured;
    Skipped<Array<float, 1>> derivative;
  };
};

}  // namespace eagerx::models::testing
