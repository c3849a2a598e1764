// 1,000 steps of 1 ms of a robot that eagerx-urdf made, on MultibodyEngine: compiled with
// -include of its header, whose class is Robot. First without torques, then with random ones.
// Prints a line, and fails where a state is not finite, a joint is faster than 1.5 times its limit,
// or energy comes from nothing.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <models/engines/multibody_engine/multibody_simulator.hpp>
#include <random>

namespace {

using namespace eagerx::models;

struct Config {
  static constexpr std::array<double, 3> origin{};
  static constexpr bool touches_itself = false;
  static constexpr double friction = 1.0, bounce = 0.0;
};
struct Io {
  using Real = STEPS_REAL;
  using Config = ::Config;
};
using Model = Robot<Io>;
using Simulator = MultibodySimulator<Model>;
constexpr std::size_t kJoints = Model::kJoints.size();
constexpr Vector3 kGravity{{0.0, 0.0, -9.81}};

double kinetic_and_potential(const Simulator& simulator, double& kinetic) {
  double potential = 0.0;
  kinetic = 0.0;
  for (std::size_t b = 0; b < Model::kBodies.size(); ++b) {
    const RigidBody& body = Model::kBodies[b];
    const RigidState at = simulator.state(b);
    const Vector3 w = rotate(inverse(at.rotation), at.angular_velocity);
    const Vector3 &i = body.inertia, &p = body.products;
    kinetic += 0.5 * body.mass * dot(at.velocity, at.velocity) +
               0.5 * (i[0] * w[0] * w[0] + i[1] * w[1] * w[1] + i[2] * w[2] * w[2]) +
               p[0] * w[0] * w[1] + p[1] * w[0] * w[2] + p[2] * w[1] * w[2];
    potential -= body.mass * dot(kGravity, at.position);
  }
  return kinetic + potential;
}

struct Seen {
  bool finite = true;
  double fastest = 0.0;  // of limits of speed
  double gained = 0.0;   // energy, of the largest kinetic energy
};

/// All that a joint has, where its speed is limited to what steps of 1 ms can follow; else what
/// makes it faster by 2 rad/s until the next one.
double torque_of(std::size_t j) {
  const RigidJoint& joint = Model::kJoints[j];
  if (joint.max_velocity <= 50.0) return std::min(joint.max_torque, 50.0);
  const RigidBody& child = Model::kBodies[scene::find(Model::kBodies, joint.child)];
  return std::min(joint.max_torque, 100.0 * inertia_of_joint(joint, child));
}

Seen run(bool pushed) {
  static Simulator simulator{};
  simulator.start(kGravity);
  for (std::size_t j = 0; j < kJoints; ++j) {
    const RigidJoint& joint = Model::kJoints[j];
    if (multibody::moves(joint.kind))
      simulator.want_joint(j, {{std::clamp(0.0, joint.low, joint.high), 0.0}, {0.0, 0.0}});
  }
  simulator.begin_episode();
  constexpr multibody::ContactSettings<Io::Real> kSettings{2e4, 400.0, 0.005, 0.2, 0.001};
  std::mt19937 random(1);
  double kinetic = 0.0, most = 1e-3, highest = 0.0;
  const double begin = kinetic_and_potential(simulator, kinetic);
  Seen seen;
  for (int i = 0; i < 1000; ++i) {
    for (std::size_t j = 0; pushed && i % 20 == 0 && j < kJoints; ++j) {
      if (!multibody::moves(Model::kJoints[j].kind)) continue;
      const double effort = torque_of(j);
      simulator.set_joint_torque(
          j, static_cast<Io::Real>(effort * (static_cast<double>(random() % 2001) / 1000.0 - 1.0)));
    }
    simulator.step(kSettings, 4);
    highest = std::max(highest, kinetic_and_potential(simulator, kinetic) - begin);
    most = std::max(most, kinetic);
    seen.finite = seen.finite && std::isfinite(kinetic);
    for (std::size_t j = 0; j < kJoints; ++j) {
      if (!multibody::moves(Model::kJoints[j].kind)) continue;
      const double v = static_cast<double>(simulator.joint_velocity(j));
      seen.fastest = std::max(seen.fastest, std::abs(v) / Model::kJoints[j].max_velocity);
    }
  }
  seen.gained = highest / most;
  return seen;
}

}  // namespace

int main() {
  const Seen still = run(false), pushed = run(true);
  const bool good = still.finite && pushed.finite && still.fastest < 1.5 && pushed.fastest < 1.5 &&
                    still.gained < 0.05;
  std::printf("%s joints %zu, energy gained %.4f, speed of its limit %.3f, with torques %.3f%s\n",
              good ? "ok  " : "BAD ", kJoints, still.gained, still.fastest, pushed.fastest,
              still.finite && pushed.finite ? "" : ", not finite");
  return good ? 0 : 1;
}
