// Io structs as the generator emits them, written by hand.
#pragma once

#include <array>
#include <cstdint>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <eagerx/window.hpp>
#include <models/engines/ode_engine/ode_engine.hpp>
#include <models/objects/pendulum/pendulum_ode.hpp>

namespace eagerx::models::testing {

/// A window of the last message of a source that has sent at every tick.
template <class Message>
using Latest = Window<Message, Rate<30>, 1, 1, true>;
/// The same for a skipped connection, empty at tick 0.
template <class Message>
using Skipped = Window<Message, Rate<30>, 1, 1, false>;

struct NoStates {};
struct NoConfig {};

template <class RealType>
struct PendulumModelIo {
  using Real = RealType;
  using Config = NoConfig;
};
template <class Real>
using PendulumSimulator = OdeSimulator<PendulumOde<PendulumModelIo<Real>>>;

/// EAGERx's defaults; change single values in a derived struct.
struct OdeConfig {
  static constexpr auto method = OdeMethod::dopri5;
  static constexpr int substeps = 30;
  static constexpr double rtol = 2e-8;
  static constexpr double atol = 2e-8;
  static constexpr double hmax = 0.0;
  static constexpr double hmin = 0.0;
  static constexpr int mxstep = 0;
};
template <int Substeps>
struct Rk4Config : OdeConfig {
  static constexpr auto method = OdeMethod::rk4;
  static constexpr int substeps = Substeps;
};
template <class RealType, class ConfigType = OdeConfig, class RateType = eagerx::Rate<30>>
struct EngineIo {
  using Real = RealType;
  using Rate = RateType;
  using Config = ConfigType;
  using States = NoStates;
};

/// Advances a simulator by one tick of an engine.
template <class Io, class Simulator>
void tick(Simulator& simulator) {
  OdeEngine<Io> engine;
  engine.callback({1}, simulator);
}

}  // namespace eagerx::models::testing
