// Shared parts of blocks with a model of a robot: its joints, messages as numbers, and torques with
// limits.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/math.hpp>
#include <models/engines/multibody_engine/robot_joints.hpp>
#include <models/engines/multibody_engine/robot_reach.hpp>
#include <models/engines/multibody_engine/spatial.hpp>
#include <models/engines/open_dynamics_engine/scene.hpp>
#include <models/nodes/action_limits/per_element.hpp>
#include <models/nodes/block.hpp>
#include <type_traits>

namespace eagerx::models {

/// `Io::Config` has `model`, an object for MultibodyEngine, and `joints`.
template <class Io>
class RobotBlock {
 public:
  void reset(const typename Io::States& /*states*/) {}

 protected:
  using Real = typename Io::Real;
  using Lane = LaneOf<Real>;
  using Config = typename Io::Config;
  using Model = typename Config::model::Model;
  using Joints = multibody::RobotJoints<Model, Config>;
  static constexpr std::size_t kJoints = Joints::kCount;
  using Numbers = std::array<Real, kJoints>;
  static_assert(RigidModel<Model> && scene::bodies_exist<Model>() && scene::is_tree<Model>() &&
                    multibody::has_only_trees_of_hinges<Model>() && multibody::has_leaders<Model>(),
                "the robot is a tree of bodies on hinges, sliders and fixed joints");

  /// The message of an input, NaN before the first message.
  template <class Window>
  static auto numbers(const Window& window) {
    std::array<Real, elements_of<Window>> x;
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] = newest<Real>(window, i, Real(FloatFormat<Lane>::nan));
    return x;
  }
  /// The same, with a number for each joint.
  template <class Window>
  static Numbers of_joints(const Window& window) {
    static_assert(elements_of<Window> == kJoints,
                  "inputs about joints have one element for each of `joints`");
    return numbers(window);
  }
  static Numbers zeros() {
    Numbers x;
    x.fill(Real(Lane(0)));
    return x;
  }
  /// Coordinates of links, and their velocities or accelerations.
  static auto places(const Numbers& q) { return multibody::of_links<Model, Joints, Real>(q, true); }
  static auto rates(const Numbers& v) { return multibody::of_links<Model, Joints, Real>(v, false); }
  static multibody::Vec<Real> vector(const std::array<double, 3>& v) {
    return {Real(static_cast<Lane>(v[0])), Real(static_cast<Lane>(v[1])),
            Real(static_cast<Lane>(v[2]))};
  }
  template <std::size_t N>
  static TruthOf<Real> are_finite(const std::array<Real, N>& x) {
    TruthOf<Real> finite(true);
    for (const Real& element : x) finite = finite && eagerx::isfinite(element);
    return finite;
  }
};

/// A block whose output `u` are torques [N·m, N] within `low` and `high`, with `gravity`. The base
/// of the robot does not move.
template <class Io>
class TorqueBlock : public RobotBlock<Io> {
 protected:
  using Base = RobotBlock<Io>;
  using Base::kJoints;
  using typename Base::Config, typename Base::Lane, typename Base::Numbers, typename Base::Real;
  static constexpr auto kLow = constants<Real>(Config::low);
  static constexpr auto kHigh = constants<Real>(Config::high);
  static_assert(multibody::count_free<typename Base::Model>() == 0,
                "torques are known of a robot whose base is fixed to the world");
  static_assert(elements_of<decltype(Io::Outputs::u)> == kJoints,
                "`size` is the number of `joints`");
  static_assert(Config::gravity.size() == 3, "`gravity` has three values");
  static_assert(is_one_or_each(kLow, kJoints) && is_one_or_each(kHigh, kJoints),
                "`low` and `high` have one value, or one for each joint");
  static_assert(in_order(Config::low, Config::high), "`low` is not above `high`");

  static auto gravity() { return Base::vector(Config::gravity); }
  /// Torques that are not finite are 0, moved into the limits.
  static void put_torques(const Numbers& u, typename Io::Outputs& out) {
    const TruthOf<Real> right = Base::are_finite(u);
    for (std::size_t i = 0; i < kJoints; ++i) {
      const Real limited = select(right, u[i], Real(Lane(0)));
      put(out.u, i, eagerx::clamp(limited, each<Real>(kLow, i), each<Real>(kHigh, i)));
    }
  }
  /// Number i of a list with one value for all joints, or one for each.
  template <std::size_t N>
  static Real setting(const std::array<double, N>& list, std::size_t i) {
    return Real(static_cast<Lane>(list[N == 1 ? 0 : i]));
  }
};

/// A point of a body: `body` and `point`, from its center of mass.
template <class Io>
struct PointOfRobot {
  using Config = typename Io::Config;
  using Model = typename Config::model::Model;
  static constexpr std::size_t kBody = scene::find(Model::kBodies, Config::body);
  static_assert(kBody < Model::kBodies.size(), "`body` is not a body of the robot");
  static_assert(Config::point.size() == 3, "`point` has three values");
};

/// Where a point is to be: N = 3, [x, y, z], or N = 7, with a quaternion [w, x, y, z].
template <class Real, std::size_t N>
struct PoseGoal {
  static_assert(N == 3 || N == 7, "`goal` is a position [3], or position and quaternion [7]");
  static constexpr std::size_t kRows = N == 3 ? 3 : 6;
  using Rows = std::array<Real, kRows>;
  std::array<Real, N> goal;

  /// Goal less position [m], then the rotation from there to the goal's [rad].
  template <class Reach>
  [[nodiscard]] Rows error(const Reach& hand) const {
    Rows e;
    e[0] = goal[0] - hand.position.x, e[1] = goal[1] - hand.position.y;
    e[2] = goal[2] - hand.position.z;
    if constexpr (N == 7) {
      const multibody::Turn<Real> to{goal[3], goal[4], goal[5], goal[6]};
      const auto turn = multibody::rotation_between(to, hand.rotation);
      e[3] = turn.x, e[4] = turn.y, e[5] = turn.z;
    }
    return e;
  }
};

/// The scalar product, added from left to right.
template <class Real, std::size_t N>
constexpr Real product_of(const std::array<Real, N>& a, const std::array<Real, N>& b) {
  Real sum = a[0] * b[0];
  for (std::size_t i = 1; i < N; ++i) sum += a[i] * b[i];
  return sum;
}

}  // namespace eagerx::models
