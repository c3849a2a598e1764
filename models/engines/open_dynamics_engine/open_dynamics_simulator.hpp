// OpenDynamicsEngine's data of each object.
#pragma once

#include <ode/ode.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <models/engines/open_dynamics_engine/joint_drive.hpp>
#include <models/engines/open_dynamics_engine/reset_targets.hpp>
#include <models/engines/open_dynamics_engine/rigid_joints.hpp>
#include <models/engines/open_dynamics_engine/rigid_parts.hpp>
#include <models/engines/open_dynamics_engine/rigid_world.hpp>
#include <models/engines/open_dynamics_engine/scene.hpp>
#include <models/engines/open_dynamics_engine/spring_constraint.hpp>

namespace eagerx::models {

/// Bodies, joints and geometries of one object. Positions of items are those in the model's lists.
/// Engine states only store their values (want_…, parameters), and place() applies all of them, so
/// their order does not matter. Torques and inputs that are not finite count as zero. All bytes are
/// zero until build().
template <RigidModel ModelType>
class OpenDynamicsSimulator {
 public:
  using Model = ModelType;
  using Real = typename Model::Real;
  using Number = double;  // that engine nodes give and take
  static constexpr std::size_t kBodies = Model::kBodies.size();
  static constexpr std::size_t kJoints = Model::kJoints.size();
  static constexpr std::size_t kGeometries = Model::kGeometries.size();
  static_assert(
      scene::bodies_exist<Model>(),
      "OpenDynamicsEngine: a joint or geometry of the model names a body that it does not have");
  static_assert(scene::is_tree<Model>(),
                "OpenDynamicsEngine: joints must make a tree, with parents before their children");
  static_assert(!scene::has_mimics<Model>(),
                "OpenDynamicsEngine: no joint mimics another one; MultibodyEngine can do it");
  static_assert(
      scene::has_level_plane_for_heights<Model>(),
      "OpenDynamicsEngine: heights of the ground need a plane that they are above, a level one");

  static constexpr std::size_t inputs() {
    if constexpr (requires { Model::kInputs; }) return Model::kInputs;
    return 0;
  }
  static constexpr std::size_t parameter_count() {
    if constexpr (requires { Model::kParameters; }) return Model::kParameters;
    return 0;
  }

  std::array<double, inputs()> input{};                // as actuate() of the model reads them
  std::array<double, parameter_count()> parameters{};  // as configure() of the model reads them

  /// Once, in this order, by the engine: build() and, for the reference pose at rest, restart().
  void build(dWorldID world, dSpaceID space) {
    world_ = world;
    for (std::size_t b = 0; b < kBodies; ++b) body_[b] = dBodyCreate(world);
    for (std::size_t j = 0; j < kJoints; ++j) {
      joint_[j] = create_joint(world, Model::kJoints[j], body_[kChild[j]], parent_body(j));
      spring_[j].create(world, Model::kJoints[j], body_[kChild[j]], parent_body(j));
    }
    for (std::size_t g = 0; g < kGeometries; ++g) create_shape(g, space);
    shapes_.begin = shape_.data();
    shapes_.count = kGeometries;
    shapes_.simulator = this;
    shapes_.fastest = fastest_joint;
    if constexpr (requires { Model::kTouchesItself; })
      shapes_.touch_each_other = Model::kTouchesItself;
  }
  RigidShapes& shapes() { return shapes_; }

  void restart() {
    for (std::size_t b = 0; b < kBodies; ++b) {
      reference_[b] = Model::kBodies[b].position;
      set_mass(b, Model::kBodies[b].mass, Model::kBodies[b].inertia, Model::kBodies[b].products);
    }
    for (std::size_t j = 0; j < kJoints; ++j) {
      anchor_[j] = Model::kJoints[j].anchor;
      turns_[j] = {};
      drive_[j].restart();
    }
    for (std::size_t g = 0; g < kGeometries; ++g) {
      shape_[g].friction = Model::kGeometries[g].friction;
      shape_[g].bounce = Model::kGeometries[g].bounce;
    }
    heights_.roughness = 1.0;
    if constexpr (parameter_count() > 0) {
      const auto defaults = Model::default_parameters();
      for (std::size_t i = 0; i < parameter_count(); ++i)
        parameters[i] = static_cast<double>(defaults[i]);
    }
    input = {};
    force_ = {};
    reconfigure();
    for (std::size_t b = 0; b < kBodies; ++b) place_body(body_[b], reference_state(b));
    place();
  }

  // ---- what engine states want of the next place()
  void want_joint(std::size_t joint, const JointCoordinates& coordinates) {
    targets_.set_joint(joint, coordinates);
    placed_ = false;
  }
  /// The last argument of want_joint() for the next place(), else the current value.
  JointCoordinates next_joint(std::size_t joint) const {
    return targets_.has_joint(joint) ? targets_.joint(joint) : present(joint);
  }
  /// Of a body that no joint holds; the rotation need not have length 1.
  void want_pose(std::size_t body, const Pose& pose) {
    targets_.set_pose(body, pose);
    placed_ = false;
  }
  void want_twist(std::size_t body, const Twist& twist) {
    targets_.set_twist(body, twist);
    placed_ = false;
  }
  /// After `parameters` have been set.
  void reconfigure() {
    reconfigured_ = true;
    placed_ = false;
  }
  void set_friction(std::size_t geometry, double friction) {
    shape_[geometry].friction = eagerx::max(finite_or_zero(friction), 0.0);
  }
  /// Factor of the heights of the ground.
  void set_roughness(double factor) {
    if (is_factor(factor)) heights_.roughness = factor;
  }
  void set_gravity(const Vector3& gravity) {  // of the whole world
    dWorldSetGravity(world_, finite_or_zero(gravity[0]), finite_or_zero(gravity[1]),
                     finite_or_zero(gravity[2]));
  }

  // ---- for configure() of the model
  /// Mass [kg], inertia about the axes through the centre of mass and its products [kg·m²]. Values
  /// that are not positive become the smallest that the library can compute with.
  void set_mass(std::size_t body, double mass, const Vector3& inertia,
                const Vector3& products = {}) {
    const auto positive = [](double value) { return value > kLeast ? value : kLeast; };
    dMass all;
    dMassSetParameters(&all, positive(mass), 0, 0, 0, positive(inertia[0]), positive(inertia[1]),
                       positive(inertia[2]), products[0], products[1], products[2]);
    dBodySetMass(body_[body], &all);
  }
  /// Mass alone; the inertia changes in proportion. One that is not positive changes nothing.
  void set_mass(std::size_t body, double mass) {
    if (!(mass > 0.0) || !eagerx::isfinite(mass)) return;
    const RigidBody& nominal = Model::kBodies[body];
    const double scale = mass / nominal.mass;
    set_mass(body, mass, scale * nominal.inertia, scale * nominal.products);
  }
  void set_strength(std::size_t joint, double factor) { drive_[joint].set_strength(factor); }
  void set_gains(std::size_t joint, double stiffness, double damping) {
    drive_[joint].set_gains(stiffness, damping);
  }
  void set_anchor(std::size_t joint, const Vector3& anchor) { anchor_[joint] = anchor; }
  void set_reference(std::size_t body, const Vector3& position) { reference_[body] = position; }

  // ---- for actuate() of the model, and for engine nodes
  void set_joint_servo(std::size_t joint, const JointServo& servo) {
    drive_[joint].set_servo(Model::kJoints[joint], servo);
  }
  void set_joint_torque(std::size_t joint, double torque) {
    drive_[joint].set_torque(Model::kJoints[joint], torque);
  }
  double joint_torque(std::size_t joint) const { return drive_[joint].torque(); }
  void set_joint_motor(std::size_t joint, double velocity, double torque) {
    drive_[joint].set_motor(joint_[joint], Model::kJoints[joint], velocity, torque);
  }
  double joint_position(std::size_t joint, std::size_t axis = 0) const {
    constexpr double kFullTurn = 6.283185307179586;
    return coordinates(joint).position[axis] + kFullTurn * static_cast<double>(turns_[joint].turns);
  }
  double joint_velocity(std::size_t joint, std::size_t axis = 0) const {
    return coordinates(joint).velocity[axis];
  }
  RigidState state(std::size_t body) const { return state_of(body_[body]); }
  /// Position and quaternion of a body; velocity and angular velocity.
  Pose pose(std::size_t body) const {
    const auto [p, q, v, w] = state(body);
    return {{p[0], p[1], p[2], q[0], q[1], q[2], q[3]}};
  }
  /// Where a point of a body is in the world [m]; `offset` is from the center of mass, in the
  /// body's axes.
  Vector3 point(std::size_t body, const Vector3& offset) const {
    const RigidState now = state(body);
    return now.position + rotate(now.rotation, offset);
  }
  Twist twist(std::size_t body) const {
    const RigidState now = state(body);
    return joined(now.velocity, now.angular_velocity);
  }
  /// specific_force() and angular velocity, in the body's axes.
  Twist imu(std::size_t body) const {
    const RigidState now = state(body);
    return joined(specific_force(body), rotate(inverse(now.rotation), now.angular_velocity));
  }
  double mass(std::size_t body) const {
    dMass all;
    dBodyGetMass(body_[body], &all);
    return all.mass;
  }
  /// In the centre of mass, in the world's axes [N]; held until it is set again.
  void set_force(std::size_t body, const Vector3& force) {
    force_[body] = {{finite_or_zero(force[0]), finite_or_zero(force[1]), finite_or_zero(force[2])}};
  }
  /// From now on, the geometry's contact_force() is known; until then it is zero.
  void watch_contact_force(std::size_t geometry) { shape_[geometry].watched = true; }
  /// Of all contacts of a geometry in the last step, in the world's axes [N].
  Vector3 contact_force(std::size_t geometry) const { return shape_[geometry].force; }
  /// Of a point in the world above the object's ground [m]; see HeightSensor.
  double height_above_ground(const Vector3& at) const {
    constexpr std::size_t kPlane = scene::find_plane<Model>();
    if constexpr (requires { Model::kHeights; }) {
      return at[2] - heights_.below(at).at[2];
    } else if constexpr (kPlane < kGeometries) {
      const RigidGeometry& plane = Model::kGeometries[kPlane];
      return dot(plane.axis, at - origin() - plane.position);
    } else {
      return at[2] - origin()[2];
    }
  }
  /// Mean acceleration over the engine's last period without gravity, in the body's axes [m/s²].
  Vector3 specific_force(std::size_t body) const {
    dVector3 g;
    dWorldGetGravity(world_, g);
    const RigidState now = state(body);
    const Vector3 change = now.velocity - velocity_before_[body];
    return rotate(inverse(now.rotation), per_period_ * change - Vector3{{g[0], g[1], g[2]}});
  }

  // ---- for the engine
  void place() {
    if (placed_) return;
    std::array<RigidState, kBodies> before, after;
    std::array<JointCoordinates, kJoints> at{};
    for (std::size_t b = 0; b < kBodies; ++b) before[b] = state(b);
    for (std::size_t j = 0; j < kJoints; ++j)
      at[j] = targets_.has_joint(j) ? finite_coordinates(targets_.joint(j)) : present(j);
    if (reconfigured_) configure();
    for (std::size_t b = 0; b < kBodies; ++b) after[b] = targets_.state(b, before[b]);
    for (std::size_t j = 0; j < kJoints; ++j) {
      const std::size_t child = kChild[j];
      after[child] =
          child_state(frame(j), parent(j, after), at[j], parent(j, before), before[child]);
    }
    for (std::size_t b = 0; b < kBodies; ++b) place_body(body_[b], after[b]);
    for (std::size_t j = 0; j < kJoints; ++j) count_turns(j, at[j].position[0]);
    for (std::size_t b = 0; b < kBodies; ++b) velocity_before_[b] = after[b].velocity;
    targets_.clear();
    placed_ = true;
  }

  void begin_tick(double period_s, int steps) {
    per_period_ = 1.0 / period_s;
    step_s_ = period_s / steps;
    for (std::size_t b = 0; b < kBodies; ++b) velocity_before_[b] = state(b).velocity;
  }
  void before_step() {
    if constexpr (requires { Model::actuate(*this); }) Model::actuate(*this);
    for (std::size_t b = 0; b < kBodies; ++b) {
      const Vector3& f = force_[b];
      dBodyAddForce(body_[b], f[0], f[1], f[2]);
    }
    for (std::size_t j = 0; j < kJoints; ++j) {
      const RigidJoint& of = Model::kJoints[j];
      const JointStep at{joint_position(j), joint_velocity(j),
                         inertia_of_joint(of, Model::kBodies[kChild[j]]), step_s_,
                         dWorldGetCFM(world_)};
      if (HingeStops::are_switched(of)) HingeStops::update(joint_[j], of, at.position);
      spring_[j].pull(of, at.position, step_s_);
      const double torque = drive_[j].torque_of_step(joint_[j], of, at);
      if (torque != 0.0) apply_torque(j, torque);
    }
  }
  void after_step() {
    for (std::size_t j = 0; j < kJoints; ++j) {
      if (Model::kJoints[j].kind == JointKind::hinge) follow_turns(j);
      if (drive_[j].is_constraint()) drive_[j].after_step(joint_velocity(j));
    }
  }

 private:
  static constexpr auto kChild = [] {
    std::array<std::size_t, kJoints> result{};
    for (std::size_t j = 0; j < kJoints; ++j)
      result[j] = scene::find(Model::kBodies, Model::kJoints[j].child);
    return result;
  }();
  static constexpr auto kParent = [] {  // kBodies: the world
    std::array<std::size_t, kJoints> result{};
    for (std::size_t j = 0; j < kJoints; ++j)
      result[j] = scene::find(Model::kBodies, Model::kJoints[j].parent);
    return result;
  }();

  static constexpr Vector3 origin() {
    if constexpr (requires { Model::kOrigin; }) return Model::kOrigin;
    return {};
  }
  /// For messages; one whose speed is not a number is the fastest.
  static const char* fastest_joint(const void* simulator, double& speed) {
    const char* name = "";
    for (std::size_t j = 0; j < kJoints; ++j) {
      const double its =
          eagerx::abs(static_cast<const OpenDynamicsSimulator*>(simulator)->joint_velocity(j));
      if (its <= speed || speed != speed) continue;
      speed = its;
      name = Model::kJoints[j].name;
    }
    return name;
  }

  dBodyID parent_body(std::size_t joint) const {
    return kParent[joint] < kBodies ? body_[kParent[joint]] : nullptr;
  }
  RigidState parent(std::size_t joint, const std::array<RigidState, kBodies>& states) const {
    return kParent[joint] < kBodies ? states[kParent[joint]] : world_state();
  }
  RigidState parent_state(std::size_t joint) const {
    return kParent[joint] < kBodies ? state(kParent[joint]) : world_state();
  }
  static RigidState world_state() { return {.position = origin(), .rotation = kNoRotation}; }
  RigidState reference_state(std::size_t body) const {
    return {.position = origin() + reference_[body], .rotation = kNoRotation};
  }
  JointFrame frame(std::size_t joint) const {
    const Vector3 of_parent = kParent[joint] < kBodies ? reference_[kParent[joint]] : Vector3{};
    return {Model::kJoints[joint], of_parent, reference_[kChild[joint]], anchor_[joint]};
  }
  JointCoordinates coordinates(std::size_t joint) const {
    return joint_coordinates(frame(joint), parent_state(joint), state(kChild[joint]));
  }
  JointCoordinates present(std::size_t joint) const {
    JointCoordinates at = coordinates(joint);
    at.position[0] = joint_position(joint);
    return at;
  }
  /// The model's masses and anchors. The library takes anchors in the pose of the moment, which has
  /// to be that of reference.
  void configure() {
    if constexpr (requires { Model::configure(*this); }) Model::configure(*this);
    for (std::size_t b = 0; b < kBodies; ++b) place_body(body_[b], reference_state(b));
    for (std::size_t j = 0; j < kJoints; ++j) {
      anchor_joint(joint_[j], Model::kJoints[j], origin() + anchor_[j]);
      spring_[j].anchor(Model::kJoints[j]);
    }
    reconfigured_ = false;
  }

  void create_shape(std::size_t g, dSpaceID space) {
    const std::size_t body = scene::find(Model::kBodies, Model::kGeometries[g].body);
    shape_[g].body = body < kBodies ? body_[body] : nullptr;
    shape_[g].geom = create_geometry(space, Model::kGeometries[g], shape_[g].body, origin());
    if constexpr (requires { Model::kHeights; }) {
      if (g != scene::find_plane<Model>()) return;
      heights_ = RigidHeights::of<Model>(origin(), Model::kGeometries[g]);
      shape_[g].heights = &heights_;
    }
  }

  void apply_torque(std::size_t j, double torque) {
    const Vector3 axis = rotate(parent_state(j).rotation, Model::kJoints[j].axis);
    push_apart(Model::kJoints[j].kind, torque * axis, body_[kChild[j]], parent_body(j));
  }

  /// f(cosine, sine) of half the angle of a hinge.
  template <class F>
  void with_half_angle(std::size_t j, F&& f) const {
    const dReal* q = dBodyGetQuaternion(body_[kChild[j]]);
    Quaternion turn{{q[0], q[1], q[2], q[3]}};
    if (kParent[j] < kBodies) turn = product(inverse(state(kParent[j]).rotation), turn);
    const Vector3& axis = Model::kJoints[j].axis;
    f(turn[0], turn[1] * axis[0] + turn[2] * axis[1] + turn[3] * axis[2]);
  }
  void follow_turns(std::size_t j) {
    with_half_angle(j, [&](double cosine, double sine) { turns_[j].follow(cosine, sine); });
  }
  void count_turns(std::size_t j, double position) {
    if (Model::kJoints[j].kind != JointKind::hinge) return;
    with_half_angle(j,
                    [&](double cosine, double sine) { turns_[j].begin(position, cosine, sine); });
  }

  static constexpr double kLeast = 1e-12;
  dWorldID world_ = nullptr;
  std::array<dBodyID, kBodies> body_{};
  std::array<dJointID, kJoints> joint_{};
  std::array<RigidShape, kGeometries> shape_{};
  RigidShapes shapes_{};
  RigidHeights heights_{};
  std::array<Vector3, kBodies> reference_{};  // centres of mass in the reference pose
  std::array<Vector3, kJoints> anchor_{};
  std::array<Vector3, kBodies> force_{};
  std::array<JointDrive, kJoints> drive_{};
  std::array<SpringConstraint, kJoints> spring_{};
  std::array<TurnCounter, kJoints> turns_{};
  std::array<Vector3, kBodies> velocity_before_{};  // at the engine's last tick
  double per_period_ = 0.0, step_s_ = 0.0;
  ResetTargets<kBodies, kJoints> targets_{};
  bool reconfigured_ = false;
  bool placed_ = false;
};

}  // namespace eagerx::models
