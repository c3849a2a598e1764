// MultibodyEngine's data of each object.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>
#include <limits>
#include <models/engines/multibody_engine/ground.hpp>
#include <models/engines/multibody_engine/kinematics.hpp>
#include <models/engines/multibody_engine/pairs.hpp>
#include <models/engines/multibody_engine/state.hpp>
#include <models/engines/multibody_engine/step.hpp>
#include <models/engines/open_dynamics_engine/rigid_joints.hpp>
#include <models/engines/open_dynamics_engine/scene.hpp>
#include <type_traits>

namespace eagerx::models {

/// Whether MultibodyEngine can simulate a model, each with its reason.
template <RigidModel Model>
struct MultibodyChecks {
  static_assert(
      scene::bodies_exist<Model>(),
      "MultibodyEngine: a joint or geometry of the model names a body that it does not have");
  static_assert(scene::is_tree<Model>(),
                "MultibodyEngine: joints must make a tree, with parents before their children");
  static_assert(multibody::has_only_trees_of_hinges<Model>(),
                "MultibodyEngine: joints are hinges, sliders and fixed ones");
  static_assert(multibody::has_leaders<Model>(),
                "MultibodyEngine: `mimics` names a hinge or slider that mimics none itself");
  static_assert(multibody::count_free<Model>() <= 1,
                "MultibodyEngine: one body of an object may be free; more of them are objects of "
                "their own");
  static_assert(multibody::count_free<Model>() == 0 || !multibody::hangs_on_world<Model>(),
                "MultibodyEngine: an object with a free body has no joint on the world");
  static_assert(multibody::count_planes<Model>() <= 1,
                "MultibodyEngine: an object touches one plane");
  static constexpr bool touches_itself() {
    if constexpr (requires { Model::kTouchesItself; }) return Model::kTouchesItself;
    return false;
  }
  static_assert(!touches_itself() || multibody::count_pairs<Model>() > 0,
                "MultibodyEngine: bodies of an object do not touch each other, but for those of "
                "`kPairs`");
  static_assert(multibody::has_round_pairs<Model>(),
                "MultibodyEngine: `kPairs` names spheres and capsules of bodies");
  static_assert(
      !requires { Model::template configure<int>; },
      "MultibodyEngine: masses and places of the model are constants, so it has no "
      "configure()");
  static_assert(!multibody::kHasHeights<Model> || multibody::count_planes<Model>() == 1,
                "MultibodyEngine: heights of the ground need a plane that they are above");
  static_assert(!multibody::kHasHeights<Model> || multibody::plane_normal<Model>()[2] == 1.0,
                "MultibodyEngine: heights of the ground are above a level plane");
  static constexpr bool kHold = true;
};

/// Joints, bodies and geometries of one object, by their positions in the model's lists. Torques
/// and inputs that are not finite count as zero. All bytes are zero until start().
template <RigidModel ModelType>
class MultibodySimulator {
  static_assert(MultibodyChecks<ModelType>::kHold);

 public:
  using Model = ModelType;
  using Real = typename Model::Real;
  using Number = Real;  // that engine nodes give and take
  using Lane = LaneOf<Real>;
  static constexpr std::size_t kBodies = Model::kBodies.size();
  static constexpr std::size_t kJoints = Model::kJoints.size();
  static constexpr std::size_t kGeometries = Model::kGeometries.size();

  static constexpr std::size_t inputs() {
    if constexpr (requires { Model::kInputs; }) return Model::kInputs;
    return 0;
  }
  static constexpr std::size_t parameter_count() {
    if constexpr (requires { Model::kParameters; }) return Model::kParameters;
    return 0;
  }
  Array<Real, multibody::at_least_one(inputs())> input{};  // as actuate() of the model reads them
  Array<Real, multibody::at_least_one(parameter_count())> parameters{};

  /// The reference pose at rest; parameters, masses and friction of the model.
  void start(const Vector3& gravity) {
    state_ = {};
    state_.position = multibody::constant<Real>(origin() + multibody::kTree<Model>.reference);
    state_.rotation = {one(), zero(), zero(), zero()};
    for (auto& scale : state_.mass_scale) scale = one();
    for (std::size_t g = 0; g < kGeometries; ++g)
      state_.friction[g] = number(Model::kGeometries[g].friction);
    for (std::size_t j = 0; j < kJoints; ++j) {
      if (kLinkOfJoint[j] != multibody::kNone)
        state_.drive[kLinkOfJoint[j]].motor_torque = number(Model::kJoints[j].friction);
    }
    for (auto& drive : state_.drive)
      drive.strength = drive.stiffness_scale = drive.damping_scale = one();
    state_.gravity = multibody::constant<Real>(gravity);
    state_.roughness = one();
    input = {};
    if constexpr (parameter_count() > 0) {
      const auto defaults = Model::default_parameters();
      for (std::size_t i = 0; i < parameter_count(); ++i)
        parameters[i] = number(static_cast<double>(defaults[i]));
    }
    gravity_set_ = CountOf<Real>(0U);
    begin_episode();
  }

  // ---- for engine states, which are never vectorized
  void want_joint(std::size_t joint, const JointCoordinates& to) {
    const std::size_t link = kLinkOfJoint[joint];
    if (link == multibody::kNone) return;
    state_.q[link] = number(sign(link) * finite(to.position[0]));
    state_.v[link] = number(sign(link) * finite(to.velocity[0]));
  }
  JointCoordinates next_joint(std::size_t joint) const {
    JointCoordinates at;
    at.position[0] = static_cast<double>(joint_position(joint));
    at.velocity[0] = static_cast<double>(joint_velocity(joint));
    return at;
  }
  /// Of the free body; the rotation need not have length 1.
  void want_pose(std::size_t /*body*/, const Pose& pose) {
    const Quaternion q = normalised({{pose[3], pose[4], pose[5], pose[6]}});
    state_.position = vector(pose[0], pose[1], pose[2]);
    state_.rotation = {number(q[0]), number(q[1]), number(q[2]), number(q[3])};
  }
  void want_twist(std::size_t /*body*/, const Twist& twist) {
    state_.velocity = vector(twist[0], twist[1], twist[2]);
    state_.spin = vector(twist[3], twist[4], twist[5]);
  }
  /// The model's actuate() reads parameters where they are.
  void reconfigure() {}
  void set_friction(std::size_t geometry, double friction) {
    state_.friction[geometry] = number(eagerx::max(finite(friction), 0.0));
  }
  /// Of this object; the engine hands it on to the others.
  void set_gravity(const Vector3& gravity) {
    state_.gravity = vector(gravity[0], gravity[1], gravity[2]);
    gravity_set_ = CountOf<Real>(1U);
  }
  /// The inertia changes in proportion. A mass that is not positive changes nothing.
  void set_mass(std::size_t body, double mass) {
    if (!(mass > 0.0) || !eagerx::isfinite(mass)) return;
    state_.mass_scale[body] = number(mass / Model::kBodies[body].mass);
  }
  /// Factors on the torques of actuators; negative or non-finite ones are ignored.
  void set_strength(std::size_t joint, double factor) {
    if (is_factor(factor)) state_.drive[link_of(joint)].strength = number(factor);
  }
  void set_gains(std::size_t joint, double stiffness, double damping) {
    auto& drive = state_.drive[link_of(joint)];
    if (is_factor(stiffness)) drive.stiffness_scale = number(stiffness);
    if (is_factor(damping)) drive.damping_scale = number(damping);
  }
  /// Of the free body, from where the model has it [m].
  void set_center_of_mass(std::size_t /*body*/, const Vector3& shift) {
    state_.shift = vector(shift[0], shift[1], shift[2]);
    state_.shifted = CountOf<Real>(1U);
  }
  /// Factor of the heights of the ground.
  void set_roughness(double factor) {
    if (is_factor(factor)) state_.roughness = number(factor);
  }
  double mass(std::size_t body) const {
    return static_cast<double>(state_.mass_scale[body]) * Model::kBodies[body].mass;
  }

  // ---- for actuate() of the model, and for engine nodes
  // No actuator has more torque than the joint's max_torque.
  /// Held until it is set again, instead of torques.
  void set_joint_servo(std::size_t joint, const JointServoOf<Real>& servo) {
    const std::size_t link = link_of(joint);
    auto& drive = state_.drive[link];
    drive.position = finite(servo.position) * signs(link);
    drive.stiffness = servo.stiffness;
    drive.damping = servo.damping;
    drive.most = eagerx::min(servo.max_torque, strongest(joint));
  }
  /// Held until it is set again: torque of a hinge about its axis [N·m], force of a slider [N].
  void set_joint_torque(std::size_t joint, const Real& torque) {
    const std::size_t link = link_of(joint);
    const Real most = strongest(joint);
    state_.drive[link].torque = eagerx::max(-most, eagerx::min(finite(torque), most)) * signs(link);
  }
  /// Of the actuator, in the last step.
  Real joint_torque(std::size_t joint) const {
    const std::size_t link = link_of(joint);
    return state_.drive[link].applied * signs(link);
  }
  /// Makes hinge or slider move at `velocity` with `torque` at most. A motor that is not stronger
  /// than the joint's friction does nothing.
  void set_joint_motor(std::size_t joint, const Real& velocity, const Real& torque) {
    const std::size_t link = link_of(joint);
    const Real friction = number(Model::kJoints[joint].friction);
    auto& drive = state_.drive[link];
    const Real most = eagerx::min(finite(torque), strongest(joint)) * drive.strength - friction;
    const auto works = most > zero();
    drive.motor_velocity = eagerx::select(works, finite(velocity) * signs(link), zero());
    drive.motor_torque = eagerx::select(works, most, friction);
  }
  Real joint_position(std::size_t joint, std::size_t /*axis*/ = 0) const {
    const std::size_t link = link_of(joint);
    return state_.q[link] * signs(link);
  }
  Real joint_velocity(std::size_t joint, std::size_t /*axis*/ = 0) const {
    const std::size_t link = link_of(joint);
    return state_.v[link] * signs(link);
  }
  /// Position and quaternion of a body; velocity and angular velocity.
  Array<Real, 7> pose(std::size_t body) const {
    const auto [p, q, v, w] = multibody::placed<Model>(state_, body);
    return {{p.x, p.y, p.z, q.w, q.x, q.y, q.z}};
  }
  /// Where a point of a body is in the world [m]; `offset` is from the center of mass, in the
  /// body's axes.
  Array<Real, 3> point(std::size_t body, const Vector3& offset) const {
    const auto at = multibody::placed<Model>(state_, body);
    const auto arm = multibody::rotated(at.rotation, multibody::constant<Real>(offset));
    const auto place = at.position + arm;
    return {{place.x, place.y, place.z}};
  }
  Array<Real, 6> twist(std::size_t body) const {
    const auto [p, q, v, w] = multibody::placed<Model>(state_, body);
    return {{v.x, v.y, v.z, w.x, w.y, w.z}};
  }
  /// Specific force, the mean over the engine's last period, and angular velocity in the body's
  /// axes.
  Array<Real, 6> imu(std::size_t body) const {
    const auto now = multibody::placed<Model>(state_, body);
    const auto before = multibody::placed<Model>(before_, body);
    const auto back = multibody::opposite(now.rotation);
    const auto a =
        multibody::rotated(back, (now.velocity - before.velocity) * per_period_ - state_.gravity);
    const auto w = multibody::rotated(back, now.spin);
    return {{a.x, a.y, a.z, w.x, w.y, w.z}};
  }
  /// For drawings, which are never vectorized.
  RigidState state(std::size_t body) const {
    const auto [p, q, v, w] = multibody::placed<Model>(state_, body);
    const auto wide = [](const Real& x) { return static_cast<double>(x); };
    return {{{wide(p.x), wide(p.y), wide(p.z)}},
            {{wide(q.w), wide(q.x), wide(q.y), wide(q.z)}},
            {{wide(v.x), wide(v.y), wide(v.z)}},
            {{wide(w.x), wide(w.y), wide(w.z)}}};
  }
  /// In the centre of mass, in the world's axes [N]; held until it is set again.
  void set_force(std::size_t body, const Array<Real, 3>& force) {
    state_.outer[body] = {finite(force[0]), finite(force[1]), finite(force[2])};
    auto some = zero() != zero();
    for (const auto& f : state_.outer)
      some = some || f.x != zero() || f.y != zero() || f.z != zero();
    state_.pushed = one_if<Real>(some);
  }
  void watch_contact_force(std::size_t /*geometry*/) {}
  /// Of all contacts of a geometry in the last step, in the world's axes [N].
  Array<Real, 3> contact_force(std::size_t geometry) const {
    multibody::Vec<Real> sum = multibody::all(zero());
    const bool is_plane = Model::kGeometries[geometry].kind == ShapeKind::plane;
    for (std::size_t p = 0; p < multibody::kTree<Model>.points.size(); ++p) {
      if (is_plane) sum = sum - state_.force[p];
      if (multibody::kTree<Model>.points[p].geometry == geometry) sum = sum + state_.force[p];
    }
    for (std::size_t p = 0; p < multibody::count_pairs<Model>(); ++p) {
      const auto& pair = multibody::kPairsOf<Model>[p];
      if (pair[0].geometry == geometry) sum = sum + state_.pair_force[p];
      if (pair[1].geometry == geometry) sum = sum - state_.pair_force[p];
    }
    return {{sum.x, sum.y, sum.z}};
  }

  /// Of a point in the world above the object's ground [m]; see HeightSensor.
  Real height_above_ground(const Array<Real, 3>& at) const {
    const auto point = multibody::constant<Real>(multibody::plane_point<Model>());
    return multibody::Ground<Model>::height(state_,
                                            multibody::Vec<Real>{at[0], at[1], at[2]} - point);
  }

  // ---- for the engine
  void begin_episode() {
    multibody::follow_leaders<Model>(state_);
    for (auto& force : state_.force) force = multibody::all(zero());
    for (auto& force : state_.pair_force) force = multibody::all(zero());
    for (auto& drive : state_.drive) drive.applied = zero();
    before_ = state_;
  }
  /// f(gravity) if it was set at this reset.
  template <class F>
  void take_gravity(F&& f) {
    if (gravity_set_ == CountOf<Real>(0U)) return;
    gravity_set_ = CountOf<Real>(0U);
    f(state_.gravity);
  }
  void share_gravity(const multibody::Vec<Real>& gravity) { state_.gravity = gravity; }
  void begin_tick(Lane per_period) {
    per_period_ = Real(per_period);
    before_ = state_;
  }
  void actuate() {
    if constexpr (requires { Model::actuate(*this); }) Model::actuate(*this);
  }
  [[gnu::always_inline]] void step(const multibody::ContactSettings<Lane>& settings, int sweeps) {
    const Real height = state_.position.z - number(plane_height());
    multibody::Step<Model>(state_, settings, height).advance(sweeps);
  }
  void end_tick() {
    auto wrong = !eagerx::isfinite(state_.position.x + state_.position.y + state_.position.z);
    for (const auto& q : state_.q) wrong = wrong || !eagerx::isfinite(q);
    const CountOf<Real> most(std::numeric_limits<std::uint32_t>::max());
    faults_ += one_if<Real>(wrong && faults_ != most);
  }
  /// Ticks after which the state was not finite, since the start of the program; saturates.
  CountOf<Real> faults() const { return faults_; }
  /// Calls f(name, count) for each count in the summary.
  template <class F>
  void for_each_count(F&& f) const {
    f("states not finite", std::uint64_t{faults_});
  }
  const multibody::State<Model>& numbers() const { return state_; }

 private:
  static constexpr auto kLinkOfJoint = [] {
    std::array<std::size_t, kJoints + 1> result{};
    for (std::size_t j = 0; j < kJoints; ++j) result[j] = multibody::kNone;
    for (std::size_t l = 0; l < multibody::kTree<Model>.links.size(); ++l)
      result[multibody::kTree<Model>.links[l].joint] = l;
    return result;
  }();
  static constexpr Vector3 origin() {
    if constexpr (requires { Model::kOrigin; }) return Model::kOrigin;
    return {};
  }
  static constexpr double plane_height() {
    for (const auto& geometry : Model::kGeometries) {
      if (geometry.kind == ShapeKind::plane) return origin()[2] + geometry.position[2];
    }
    return 0.0;
  }
  static bool is_factor(double value) { return value >= 0.0 && eagerx::isfinite(value); }
  static Real number(double value) { return Real(static_cast<Lane>(value)); }
  static Real zero() { return Real(Lane(0)); }
  static Real one() { return Real(Lane(1)); }
  static double finite(double value) requires(!std::is_same_v<Real, double>) {
    return eagerx::isfinite(value) ? value : 0.0;
  }
  static Real finite(const Real& value) {
    return eagerx::select(eagerx::isfinite(value), value, zero());
  }
  static multibody::Vec<Real> vector(double x, double y, double z) {
    return {number(finite(x)), number(finite(y)), number(finite(z))};
  }
  static constexpr std::size_t link_of(std::size_t joint) {
    return kLinkOfJoint[joint] == multibody::kNone ? 0 : kLinkOfJoint[joint];
  }
  static constexpr double sign(std::size_t link) {
    return multibody::kTree<Model>.links[link].sign;
  }
  static Real signs(std::size_t link) { return number(sign(link)); }
  static Real strongest(std::size_t joint) { return number(Model::kJoints[joint].max_torque); }

  multibody::State<Model> state_{};
  multibody::Motion<Model> before_{};  // at the engine's last tick
  Real per_period_{};                  // [1/s]
  CountOf<Real> gravity_set_{};
  CountOf<Real> faults_{};
};

}  // namespace eagerx::models
