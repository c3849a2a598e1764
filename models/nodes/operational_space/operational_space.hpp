// A model-based controller of a point of a robot.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/rate.hpp>
#include <models/engines/multibody_engine/robot_dynamics.hpp>
#include <models/engines/multibody_engine/robot_reach.hpp>
#include <models/engines/multibody_engine/symmetric_system.hpp>
#include <models/nodes/robot_block.hpp>

namespace eagerx::models {

/// u [joints] = M·a + h + damping·v, clamped, with a = a0 + M⁻¹·Jᵀ·Λ·(x'' − J'·v − J·a0),
/// x'' = goal_a + kd·(goal_v − J·v) + kp·(goal − x), a0 = posture_kp·(posture − q) − posture_kd·v,
/// Λ = (J·M⁻¹·Jᵀ + regularization·I)⁻¹.
template <class Io>
class OperationalSpace : public TorqueBlock<Io> {
  using Base = TorqueBlock<Io>;
  using Base::kJoints;
  using typename Base::Config, typename Base::Joints, typename Base::Model;
  using typename Base::Numbers, typename Base::Real;
  using Goal = PoseGoal<Real, elements_of<decltype(Io::Inputs::goal)>>;
  using Rows = typename Goal::Rows;
  static constexpr std::size_t kRows = Goal::kRows;
  using Reach = multibody::Reach<Model, Joints, Real, PointOfRobot<Io>::kBody>;
  using Robot = multibody::RobotDynamics<Model, Joints, Real>;
  static_assert(is_one_or_each(Config::posture, kJoints),
                "OperationalSpace: `posture` has one value, or one for each joint");

 public:
  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    const Numbers q = Base::of_joints(in.q), v = Base::of_joints(in.v);
    const Reach hand(Base::places(q), Base::vector(Config::point));
    const auto jacobian = hand.jacobian();
    const Rows wanted = accelerate(in, hand, jacobian, v);
    Robot robot(Base::places(q));
    const Numbers a = in_joints(robot, jacobian, wanted, posture(q, v));
    Base::put_torques(robot.torques(Base::rates(v), Base::rates(a), Base::gravity()), out);
  }

 private:
  using Jacobian = typename Reach::Jacobian;
  static Real number(double x) { return Real(constant<Real>(x)); }

  /// x'' − J'·v
  static Rows accelerate(const typename Io::Inputs& in, const Reach& hand, const Jacobian& jacobian,
                         const Numbers& v) {
    const Rows error = Goal{Base::numbers(in.goal)}.error(hand);
    const auto bias = hand.bias(Base::rates(v));
    const Real lost[6] = {bias[0].x, bias[0].y, bias[0].z, bias[1].x, bias[1].y, bias[1].z};
    Rows goal_v, a;
    goal_v.fill(Real(0));
    a.fill(Real(0));
    if constexpr (requires { in.goal_v; }) goal_v = rows(in.goal_v);
    if constexpr (requires { in.goal_a; }) a = rows(in.goal_a);
    for (std::size_t i = 0; i < kRows; ++i)
      a[i] = a[i] + number(Config::kd) * (goal_v[i] - product_of(jacobian[i], v)) +
             number(Config::kp) * error[i] - lost[i];
    return a;
  }
  template <class Window>
  static Rows rows(const Window& window) {
    static_assert(elements_of<Window> == kRows,
                  "OperationalSpace: `goal_v` and `goal_a` have 3 elements, or 6 with a rotation");
    return Base::numbers(window);
  }
  static Numbers posture(const Numbers& q, const Numbers& v) {
    Numbers a;
    for (std::size_t i = 0; i < kJoints; ++i)
      a[i] = number(Config::posture_kp) * (Base::setting(Config::posture, i) - q[i]) -
             number(Config::posture_kd) * v[i];
    return a;
  }
  /// Accelerations of joints that are nearest to `a`, weighted by the masses.
  static Numbers in_joints(const Robot& robot, const Jacobian& jacobian, const Rows& wanted,
                           Numbers a) {
    const multibody::SymmetricSystem<Real, kJoints> masses(robot.masses());
    std::array<Numbers, kRows> columns;  // M⁻¹·Jᵀ
    typename multibody::SymmetricSystem<Real, kRows>::Matrix inverse;
    Rows rest;
    for (std::size_t i = 0; i < kRows; ++i) {
      columns[i] = masses.solve(jacobian[i]);
      for (std::size_t k = 0; k <= i; ++k) inverse[i][k] = product_of(jacobian[i], columns[k]);
      inverse[i][i] += number(Config::regularization);
      rest[i] = wanted[i] - product_of(jacobian[i], a);
    }
    const Rows force = multibody::SymmetricSystem<Real, kRows>(inverse).solve(rest);
    for (std::size_t i = 0; i < kRows; ++i) {
      for (std::size_t k = 0; k < kJoints; ++k) a[k] += columns[i][k] * force[i];
    }
    return a;
  }
};

}  // namespace eagerx::models
