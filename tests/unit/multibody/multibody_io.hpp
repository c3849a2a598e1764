// MultibodyEngine with one object, without a generated program.
#pragma once

#include <array>
#include <eagerx/engine.hpp>
#include <models/engines/multibody_engine/multibody_engine.hpp>

#include "tests/unit/models/io.hpp"

namespace eagerx::models::testing {

/// The defaults of the manifest, but for the length of a step.
template <int Substeps>
struct MultibodyConfig {
  static constexpr int substeps = Substeps;
  static constexpr std::array<double, 3> gravity = {0.0, 0.0, -9.81};
  static constexpr int sweeps = 4;
  static constexpr double contact_correction = 0.2;
  static constexpr double contact_stiffness = 2e4;
  static constexpr double contact_damping = 400.0;
  static constexpr double slip_speed = 0.005;
};
template <int Substeps>
struct WeightlessMultibody : MultibodyConfig<Substeps> {
  static constexpr std::array<double, 3> gravity = {0.0, 0.0, 0.0};
};

/// An object at 50 ticks a second.
template <class ModelType, class Config = MultibodyConfig<20>>
class MultibodyScene {
 public:
  static constexpr double kPeriod = 0.02;  // [s]
  using Model = ModelType;
  using Real = typename Model::Real;
  using Io = EngineIo<Real, Config, eagerx::Rate<50>>;
  using Simulator = MultibodySimulator<Model>;

  MultibodyScene() { eagerx::start(engine, simulator); }
  /// The last part of a reset, after its engine states.
  void reset() { eagerx::reset_engine(engine, NoStates{}, simulator); }
  void tick() { engine.callback({1}, simulator); }
  void run(double seconds) {
    for (int i = 0; i < static_cast<int>(seconds / kPeriod + 0.5); ++i) tick();
  }

  Simulator simulator{};
  MultibodyEngine<Io> engine{};
};

/// A configuration's Io of an object's model.
template <class RealType, class ConfigType>
struct ModelIo {
  using Real = RealType;
  using Config = ConfigType;
};

}  // namespace eagerx::models::testing
