// MujocoEngine's data of each object: the interface of MultibodySimulator for one free body with
// joints.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <eagerx/math.hpp>
#include <memory>
#include <models/engines/open_dynamics_engine/rigid_joints.hpp>
#include <models/engines/open_dynamics_engine/scene.hpp>
#include <tests/mujoco/plant.hpp>
#include <utility>
#include <vector>

namespace eagerx::mujoco {

struct PlantSettings {
  MjcfSettings mjcf;
  double contact_time_s;
};

/// Joints, bodies and geometries by their positions in the model's lists. Values of a reset hold
/// until the next one sets them.
template <class ModelType>
class MujocoSimulator {
 public:
  using Model = ModelType;
  using Real = typename Model::Real;
  using Number = double;
  static constexpr std::size_t kBodies = Model::kBodies.size();
  static constexpr std::size_t kJoints = Model::kJoints.size();
  static constexpr std::size_t kGeometries = Model::kGeometries.size();

  void start(const PlantSettings& settings) {
    if (plant_ != nullptr) return;
    plant_ = std::make_unique<Plant<Model>>(settings.mjcf);
    for (int g = 0; g < model().ngeom; ++g)
      model().geom_solref[g * mjNREF] = settings.contact_time_s;
    mass_scale_.fill(1.0);
    strength_.fill(1.0);
    stiffness_.fill(1.0);
    damping_.fill(1.0);
    nominal_.assign(model().body_inertia, model().body_inertia + 3 * model().nbody);
    for (std::size_t g = 0; g < kGeometries; ++g) friction_[g] = Model::kGeometries[g].friction;
    mj_resetData(plant_->model, plant_->data);
    copy_positions();
  }

  // ---- for engine states
  void want_joint(std::size_t joint, const models::JointCoordinates& at) {
    if (plant_->position_of(joint) < 0) return;
    position_[size(plant_->position_of(joint))] = at.position[0];
    velocity_[size(plant_->velocity_of(joint))] = at.velocity[0];
  }
  void want_pose(std::size_t /*body*/, const models::Pose& pose) {
    std::copy_n(&pose[0], 7, position_.begin());
    mju_normalize4(&position_[3]);
  }
  void want_twist(std::size_t /*body*/, const models::Twist& twist) { twist_ = twist; }
  void set_friction(std::size_t geometry, double friction) { friction_[geometry] = friction; }
  void set_mass(std::size_t body, double mass) {
    mass_scale_[body] = mass / Model::kBodies[body].mass;
  }
  void set_center_of_mass(std::size_t body, const models::Vector3& shift) { shift_[body] = shift; }
  void set_strength(std::size_t joint, double factor) { strength_[joint] = factor; }
  void set_gains(std::size_t joint, double stiffness, double damping) {
    stiffness_[joint] = stiffness;
    damping_[joint] = damping;
  }

  // ---- for engine nodes
  void set_joint_servo(std::size_t joint, const models::JointServo& servo) {
    servo_[joint] = servo;
  }
  void set_force(std::size_t body, const models::Vector3& force) { force_[body] = force; }
  double joint_position(std::size_t joint, std::size_t /*axis*/ = 0) const {
    return data().qpos[plant_->position_of(joint)];
  }
  double joint_velocity(std::size_t joint, std::size_t /*axis*/ = 0) const {
    return data().qvel[plant_->velocity_of(joint)];
  }
  double joint_torque(std::size_t joint) const { return torque_[joint]; }
  models::Pose pose(std::size_t body) const {
    const models::RigidState at = state(body);
    const auto& [p, q] = std::pair(at.position, at.rotation);
    return {{p[0], p[1], p[2], q[0], q[1], q[2], q[3]}};
  }
  models::Twist twist(std::size_t body) const {
    const models::RigidState at = state(body);
    return models::joined(at.velocity, at.angular_velocity);
  }
  models::RigidState state(std::size_t body) const {
    const int b = id_of(body);
    models::RigidState at;
    std::copy_n(data().xpos + 3 * b, 3, &at.position[0]);
    std::copy_n(data().xquat + 4 * b, 4, &at.rotation[0]);
    double motion[6];  // angular, linear
    mj_objectVelocity(plant_->model, plant_->data, mjOBJ_XBODY, b, motion, 0);
    std::copy_n(motion + 3, 3, &at.velocity[0]);
    std::copy_n(motion, 3, &at.angular_velocity[0]);
    return at;
  }
  models::Vector3 point(std::size_t body, const models::Vector3& offset) const {
    using models::operator+;
    const models::RigidState at = state(body);
    return at.position + models::rotate(at.rotation, offset);
  }
  double height_above_ground(const models::Vector3& at) const { return at[2]; }
  void watch_contact_force(std::size_t /*geometry*/) {}
  /// Of the ground on a geometry in the last step, in the world's axes [N].
  models::Vector3 contact_force(std::size_t geometry) const {
    const int id = mj_name2id(plant_->model, mjOBJ_GEOM, Model::kGeometries[geometry].name);
    models::Vector3 sum{};
    for (int c = 0; c < data().ncon; ++c) {
      const mjContact& contact = data().contact[c];
      if (contact.geom1 != id && contact.geom2 != id) continue;
      double local[6];  // on geom2, in the contact's axes, which are the rows of `frame`
      mj_contactForce(plant_->model, plant_->data, c, local);
      const double sign = contact.geom2 == id ? 1.0 : -1.0;
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) sum[i] += sign * contact.frame[3 * k + i] * local[k];
      }
    }
    return sum;
  }

  // ---- for the engine
  void begin_episode() {
    set_parameters();
    mj_resetData(plant_->model, plant_->data);
    std::copy(position_.begin(), position_.end(), data().qpos);
    std::copy(velocity_.begin(), velocity_.end(), data().qvel);
    std::copy_n(&twist_[0], 3, data().qvel);
    double back[4];
    mju_negQuat(back, data().qpos + 3);
    mju_rotVecQuat(data().qvel + 3, &twist_[3], back);
    torque_ = {};
    refresh();
  }
  void advance(int substeps) {
    for (int i = 0; i < substeps; ++i) {
      push();
      mj_step(plant_->model, plant_->data);
    }
    refresh();
  }

 private:
  static_assert(models::scene::is_child<Model>(1) && !models::scene::is_child<Model>(0),
                "MujocoSimulator: the first body is free, the others hang on it");

  static std::size_t size(int i) { return static_cast<std::size_t>(i); }
  mjModel& model() const { return *plant_->model; }
  mjData& data() const { return *plant_->data; }
  int id_of(std::size_t body) const {
    return mj_name2id(plant_->model, mjOBJ_BODY, Model::kBodies[body].name);
  }
  void copy_positions() {
    position_.assign(data().qpos, data().qpos + model().nq);
    velocity_.assign(size(model().nv), 0.0);
  }

  /// Masses, centers of mass and friction.
  void set_parameters() {
    for (std::size_t b = 0; b < kBodies; ++b) {
      const int id = id_of(b);
      model().body_mass[id] = mass_scale_[b] * Model::kBodies[b].mass;
      for (int i = 0; i < 3; ++i)
        model().body_inertia[3 * id + i] = mass_scale_[b] * nominal_[size(3 * id + i)];
      std::copy_n(&shift_[b][0], 3, model().body_ipos + 3 * id);
    }
    // MuJoCo takes the larger one of both, so the plane's is 0 and the others' are the products.
    double plane = 1.0;
    for (std::size_t g = 0; g < kGeometries; ++g) {
      if (Model::kGeometries[g].kind == models::ShapeKind::plane) plane = friction_[g];
    }
    for (std::size_t g = 0; g < kGeometries; ++g) {
      const int id = mj_name2id(plant_->model, mjOBJ_GEOM, Model::kGeometries[g].name);
      const bool is_plane = Model::kGeometries[g].kind == models::ShapeKind::plane;
      model().geom_friction[3 * id] = is_plane ? 0.0 : friction_[g] * plane;
    }
    mj_setConst(plant_->model, plant_->data);
  }
  /// Forces of the step.
  void push() {
    std::fill_n(data().qfrc_applied, model().nv, 0.0);
    for (std::size_t j = 0; j < kJoints; ++j) {
      if (plant_->position_of(j) < 0) continue;
      const models::ActuatorFactors factors{strength_[j], stiffness_[j], damping_[j]};
      torque_[j] = strength_[j] *
                   models::scaled(servo_[j], factors).torque(joint_position(j), joint_velocity(j));
      data().qfrc_applied[plant_->velocity_of(j)] = torque_[j];
    }
    constexpr double kNoTorque[3] = {};
    for (std::size_t b = 0; b < kBodies; ++b) {
      const int id = id_of(b);
      mj_applyFT(plant_->model, plant_->data, &force_[b][0], kNoTorque, data().xpos + 3 * id, id,
                 data().qfrc_applied);
    }
  }
  /// Places and velocities of bodies at the state.
  void refresh() {
    mj_kinematics(plant_->model, plant_->data);
    mj_comPos(plant_->model, plant_->data);
    mj_comVel(plant_->model, plant_->data);
  }

  std::unique_ptr<Plant<Model>> plant_;
  std::vector<double> position_, velocity_, nominal_;
  models::Twist twist_{};
  std::array<double, kBodies> mass_scale_{};
  std::array<models::Vector3, kBodies> shift_{}, force_{};
  std::array<double, kJoints> strength_{}, stiffness_{}, damping_{}, torque_{};
  std::array<models::JointServo, kJoints> servo_{};
  std::array<double, kGeometries> friction_{};
};

}  // namespace eagerx::mujoco
