// Random states of robots, and the accelerations of MultibodyEngine there: what MuJoCo's are
// compared with.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "tests/unit/multibody/compared_robots.hpp"
#include "tests/unit/multibody/sampler.hpp"

namespace eagerx::models::testing {

/// All numbers are those of floats, so that float and double see the same state.
template <class Model>
struct SampledState {
  static constexpr std::size_t kJoints = Model::kJoints.size();
  static constexpr bool kFloating = multibody::count_free<Model>() == 1;
  Pose pose{};    // of the free body
  Twist twist{};  // in the axes of the world
  std::array<double, kJoints> q{}, v{}, torque{};

  /// Torques are `most_torque` at most.
  SampledState(Sampler& sample, double most_torque) {
    const auto narrow = [&](double most) {
      return static_cast<double>(static_cast<float>(sample(most)));
    };
    for (std::size_t i = 0; kFloating && i < 7; ++i) pose[i] = narrow(1.0);
    for (std::size_t i = 0; kFloating && i < 6; ++i) twist[i] = narrow(i < 3 ? 3.0 : 5.0);
    for (std::size_t j = 0; j < kJoints; ++j) {
      if (!multibody::moves(Model::kJoints[j].kind)) continue;
      q[j] = narrow(3.0);
      v[j] = narrow(5.0);
      torque[j] = narrow(most_torque);
    }
  }
};

/// Of the free body (linear, then angular, in the axes of the world), then of the joints that move
/// [m/s², rad/s²].
template <class Model>
std::vector<double> engine_accelerations(const SampledState<Model>& at) {
  using Lane = LaneOf<typename Model::Real>;
  MultibodyScene<Model> scene;
  auto& simulator = scene.simulator;
  if constexpr (SampledState<Model>::kFloating) {
    simulator.want_pose(0, at.pose);
    simulator.want_twist(0, at.twist);
  }
  for (std::size_t j = 0; j < at.kJoints; ++j) {
    if (!multibody::moves(Model::kJoints[j].kind)) continue;
    simulator.want_joint(j, {{at.q[j], 0.0}, {at.v[j], 0.0}});
    simulator.set_joint_torque(j, static_cast<Lane>(at.torque[j]));
  }
  // A step so short that damping is that of its beginning.
  const multibody::ContactSettings<Lane> settings{0, 0, 1, 0, Lane(1e-16)};
  auto state = simulator.numbers();
  multibody::Step<Model> step(state, settings, Lane(0));
  step.set_accelerations(1);
  std::vector<double> result;
  for (std::size_t i = 0; at.kFloating && i < 6; ++i)
    result.push_back(static_cast<double>(step.base_acceleration[i]));
  const auto& links = multibody::kTree<Model>.links;
  for (std::size_t j = 0; j < at.kJoints; ++j) {
    for (std::size_t l = 0; l < links.size(); ++l) {
      if (links[l].joint == j)
        result.push_back(links[l].sign * static_cast<double>(step.acceleration[l]));
    }
  }
  return result;
}

/// Largest difference, relative to the largest acceleration.
inline double relative_error(const std::vector<double>& a, const std::vector<double>& expected) {
  double worst = 0.0, scale = 0.0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    worst = std::max(worst, std::abs(a[i] - expected[i]));
    scale = std::max(scale, std::abs(expected[i]));
  }
  return a.size() == expected.size() ? worst / scale : 1.0;
}

/// Its name in the table and the largest torque that is sampled [N·m].
template <template <class> class Model>
struct ComparedRobot;
template <>
struct ComparedRobot<FreeArm> {
  static constexpr const char* kName = "arm";
  static constexpr double kMostTorque = 10.0;
};
template <>
struct ComparedRobot<FreeQuadruped> {
  static constexpr const char* kName = "quadruped";
  static constexpr double kMostTorque = 10.0;
};
template <>
struct ComparedRobot<Humanoid> {
  static constexpr const char* kName = "humanoid";
  static constexpr double kMostTorque = 10.0;
};
template <>
struct ComparedRobot<Hand> {
  static constexpr const char* kName = "hand";
  static constexpr double kMostTorque = 0.1;
};

}  // namespace eagerx::models::testing
