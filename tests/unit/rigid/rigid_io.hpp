// OpenDynamicsEngine with one object, without a generated program.
#pragma once

#include <array>
#include <cstdint>
#include <eagerx/engine.hpp>
#include <models/engines/open_dynamics_engine/open_dynamics_engine.hpp>

#include "tests/unit/models/io.hpp"

namespace eagerx::models::testing {

constexpr double kPeriod = 0.02;  // of the engine, s

/// The defaults of the manifest, but for the length of a step.
template <int Substeps>
struct RigidConfig {
  static constexpr int substeps = Substeps;
  static constexpr auto method = OpenDynamicsMethod::step;
  static constexpr int iterations = 20;
  static constexpr std::array<double, 3> gravity = {0.0, 0.0, -9.81};
  static constexpr double erp = 0.2;
  static constexpr double cfm = 1e-10;
  static constexpr double contact_erp = 0.2;
  static constexpr double contact_cfm = 1e-6;
  static constexpr int max_contacts = 64;
};
template <int Substeps>
struct QuickConfig : RigidConfig<Substeps> {
  static constexpr auto method = OpenDynamicsMethod::quick_step;
};
template <int Substeps>
struct WeightlessConfig : RigidConfig<Substeps> {
  static constexpr std::array<double, 3> gravity = {0.0, 0.0, 0.0};
};

/// An object at 50 ticks a second.
template <class Model, class Config>
class Scene {
 public:
  static constexpr double kPeriod = 0.02;
  using Io = EngineIo<double, Config, eagerx::Rate<50>>;
  using Simulator = OpenDynamicsSimulator<Model>;

  Scene() { eagerx::start(engine, simulator); }
  /// The last part of a reset, after its engine states.
  void reset() { eagerx::reset_engine(engine, NoStates{}, simulator); }
  void tick() { engine.callback({1}, simulator); }

  Simulator simulator{};
  OpenDynamicsEngine<Io> engine{};
};

}  // namespace eagerx::models::testing
