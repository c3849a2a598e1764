// The disc pendulum of EAGERx's tutorials as a rigid body on OpenDynamicsEngine.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>
#include <models/engines/open_dynamics_engine/scene.hpp>
#include <models/objects/pendulum/pendulum_ode.hpp>

namespace eagerx::models {

/// A disc on a hinge along y, θ = 0 upright: its centre of mass is l from the shaft, and its
/// inertia about that centre is J − m·l², so that it is J about the shaft. In each step the DC
/// motor and the friction of the shaft turn it with
///   K/R·u − (b + K²/R)·ω − c·tanh(d·ω/2)                                              [N·m]
/// of the step's beginning: the friction, c·d/(2·J) = 500 1/s, wants steps below 2 ms. Parameters
/// and sources as in PendulumOde. An inertia below m·l² belongs to no rigid body; the least one is
/// taken.
template <class Io>
struct PendulumBodies {
  using Real = typename Io::Real;
  using Ode = PendulumOde<Io>;
  static constexpr std::size_t kInputs = 1;
  static constexpr std::size_t kParameters = Ode::kParameters;
  static constexpr auto default_parameters() { return Ode::default_parameters(); }

  static constexpr std::array<RigidBody, 1> kBodies = {{{.name = "disc"}}};  // see configure()
  static constexpr std::array<RigidJoint, 1> kJoints = {
      {{.name = "shaft", .kind = JointKind::hinge, .child = "disc", .axis = {{0.0, 1.0, 0.0}}}}};
  static constexpr std::array<RigidGeometry, 0> kGeometries = {};

  template <class Simulator>
  static void configure(Simulator& simulator) {
    const auto& p = simulator.parameters;
    const double l = p[Ode::kLength];
    const double inertia = p[Ode::kInertia] - p[Ode::kMass] * l * l;
    simulator.set_mass(0, p[Ode::kMass], Vector3{{inertia, inertia, inertia}});
    simulator.set_reference(0, Vector3{{0.0, 0.0, l}});
  }

  template <class Simulator>
  static void actuate(Simulator& simulator) {
    const auto& p = simulator.parameters;
    const double omega = simulator.joint_velocity(0);
    const double per_volt = p[Ode::kMotorConstant] / p[Ode::kResistance];
    simulator.set_joint_torque(
        0, per_volt * (simulator.input[0] - p[Ode::kMotorConstant] * omega) -
               p[Ode::kDamping] * omega -
               p[Ode::kFriction] * eagerx::tanh(0.5 * p[Ode::kFrictionSlope] * omega));
  }
};

}  // namespace eagerx::models
