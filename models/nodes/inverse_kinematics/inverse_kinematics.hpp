// Joint positions that bring a point of a robot to a goal.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/rate.hpp>
#include <models/engines/multibody_engine/robot_reach.hpp>
#include <models/engines/multibody_engine/symmetric_system.hpp>
#include <models/nodes/robot_block.hpp>

namespace eagerx::models {

/// q [joints] after `iterations` steps q += Jᵀ·(J·Jᵀ + (damping + e²/2)·I)⁻¹·e from the last q, or
/// from `start`, within the stops. A goal that is not finite or is missing changes nothing.
template <class Io>
class InverseKinematics : public RobotBlock<Io> {
  using Base = RobotBlock<Io>;
  using Base::kJoints;
  using typename Base::Config, typename Base::Joints, typename Base::Lane, typename Base::Model;
  using typename Base::Numbers, typename Base::Real;
  using Count = CountOf<Real>;
  using Goal = PoseGoal<Real, elements_of<decltype(Io::Inputs::goal)>>;
  using Reach = multibody::Reach<Model, Joints, Real, PointOfRobot<Io>::kBody>;
  static_assert(elements_of<decltype(Io::Outputs::q)> == kJoints,
                "InverseKinematics: `size` is the number of `joints`");
  static_assert(is_one_or_each(Config::initial, kJoints),
                "InverseKinematics: `initial` has one value, or one for each joint");

 public:
  void reset(const typename Io::States& /*states*/) { begin(q_); }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    Numbers q = q_;
    if constexpr (requires { in.start; }) {
      const Numbers start = Base::of_joints(in.start);
      for (std::size_t i = 0; i < kJoints; ++i)
        q[i] = select(eagerx::isfinite(start[i]), start[i], q[i]);
    }
    const Goal goal{Base::numbers(in.goal)};
#pragma GCC unroll 1
    for (int i = 0; i < Config::iterations; ++i) step(goal, q);
    const auto error = weighted(goal.error(hand_at(q)));
    const TruthOf<Real> right = Base::are_finite(q) && Base::are_finite(error);
    for (std::size_t i = 0; i < kJoints; ++i) {
      q_[i] = select(right, q[i], q_[i]);
      put(out.q, i, q_[i]);
    }
    const Real most(constant<Real>(Config::tolerance * Config::tolerance));
    const TruthOf<Real> missed = !(product_of(error, error) <= most);
    misses_ += one_if<Real>(missed && misses_ != Count(~std::uint32_t{0}));
  }

  template <class F>
  void for_each_count(F&& f) const {
    f("misses", static_cast<std::uint32_t>(misses_));
  }

 private:
  using Rows = typename Goal::Rows;
  static constexpr std::size_t kRows = Goal::kRows;

  static void begin(Numbers& q) {
    for (std::size_t i = 0; i < kJoints; ++i)
      q[i] = Real(constant<Real>(Config::initial[Config::initial.size() == 1 ? 0 : i]));
  }
  static Reach hand_at(const Numbers& q) {
    return {Base::places(q), Base::vector(Config::point)};
  }
  /// Rotations as lengths.
  static Rows weighted(Rows e) {
    for (std::size_t i = 3; i < kRows; ++i) e[i] = e[i] * Real(constant<Real>(Config::lever));
    return e;
  }

  static void step(const Goal& goal, Numbers& q) {
    const Reach hand = hand_at(q);
    const Rows error = weighted(goal.error(hand));
    auto jacobian = hand.jacobian();
    for (std::size_t i = 3; i < kRows; ++i) {
      for (auto& element : jacobian[i]) element = element * Real(constant<Real>(Config::lever));
    }
    const Real damping =
        Real(constant<Real>(Config::damping)) + Real(Lane(0.5)) * product_of(error, error);
    typename multibody::SymmetricSystem<Real, kRows>::Matrix a;
    for (std::size_t i = 0; i < kRows; ++i) {
      for (std::size_t k = 0; k <= i; ++k) a[i][k] = product_of(jacobian[i], jacobian[k]);
      a[i][i] += damping;
    }
    const Rows x = multibody::SymmetricSystem<Real, kRows>(a).solve(error);
    for (std::size_t i = 0; i < kJoints; ++i) {
      Real change = jacobian[0][i] * x[0];
      for (std::size_t r = 1; r < kRows; ++r) change += jacobian[r][i] * x[r];
      const RigidJoint& joint = Model::kJoints[Joints::kJoints[i]];
      q[i] = eagerx::clamp(q[i] + change, Real(constant<Real>(joint.low)),
                           Real(constant<Real>(joint.high)));
    }
  }

  Numbers q_{};
  Count misses_{};
};

}  // namespace eagerx::models
