#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/backend/emit/literals.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/quote/quote.hpp"
#include "generator/urdf/robot.hpp"

namespace eagerx::urdf {
namespace {

constexpr double kAnything = 999.0;  // bounds of what nothing is said about
constexpr double kHalfTurn = 3.14;
constexpr std::size_t kMostRows = 1024;  // of RigidDrawing
constexpr int kRate = 50;                // Hz, where the graph does not say another

/// A list of numbers as YAML has it.
template <class F>
std::string numbers(const std::vector<BodyJoint>& joints, F&& number) {
  std::string text;
  for (const BodyJoint& joint : joints)
    text += (text.empty() ? "" : ", ") + gen::double_literal(number(joint) + 0.0);
  return text;
}

std::string vector_text(const Vector3& v) {
  return fmt::format("[{}, {}, {}]", gen::double_literal(v[0] + 0.0),
                     gen::double_literal(v[1] + 0.0), gen::double_literal(v[2] + 0.0));
}

double or_else(double value, double fallback) {
  return std::isfinite(value) ? value : fallback;
}
double low(const BodyJoint& joint) {
  return or_else(joint.limits.lower, -kHalfTurn);
}
double high(const BodyJoint& joint) {
  return or_else(joint.limits.upper, kHalfTurn);
}

/// The parts of a manifest, filled item by item.
class Manifest {
 public:
  explicit Manifest(const Robot& robot) : robot_(robot) {
    for (const BodyJoint& joint : robot.joints) {
      if (!joint.mimics.empty() || joint.is_fixed) continue;
      joints_.push_back(joint);
      if (joint.limits.drive.exists) driven_.push_back(joint);
    }
  }

  std::string text() {
    if (!joints_.empty()) add_joints();
    for (const Body& body : robot_.bodies) {
      if (!body.is_made) add_body(body);
    }
    for (const Shape& shape : robot_.shapes) {
      if (!shape.body.empty()) add_contact(shape.name);
    }
    add_contacts();
    if (!robot_.bodies.empty()) add_scene();
    if (robot_.ground)
      state("ground_friction", "{dtype: float32, shape: [], low: 0.2, high: 1.0}",
            "factor on the friction of everything that touches the ground",
            "GeometryFriction, config: {geometry: ground_plane}");
    const std::string gravity = vector_text(robot_.gravity);
    state("gravity", fmt::format("{{dtype: float32, shape: [3], low: {0}, high: {0}}}", gravity),
          "of the whole world, in m/s^2", "Gravity");
    return head() + config() + "sensors:\n" + sensors_ +
           (actuators_.empty() ? "" : "actuators:\n" + actuators_) + "states:\n" + states_ +
           engines() + "requires:\n" +
           "  - {that: \"len(origin) == 3\", because: \"`origin` has three values\"}\n";
  }

 private:
  static std::string names(const std::vector<BodyJoint>& joints) {
    std::string result;
    for (const BodyJoint& joint : joints) result += (result.empty() ? "" : " ") + joint.name;
    return result;
  }

  /// A list in one text. With a blank in it, it is one without quotes, too.
  static std::string yaml_names(const std::vector<BodyJoint>& joints) {
    return joints.size() == 1 ? gen::yaml_text(names(joints)) : names(joints);
  }

  std::string head() const {
    return fmt::format(
        R"(# Made by eagerx-urdf from {5}. Do not edit: change the description and convert it again.
kind: object
id: {1}
summary: "A robot with {2} and {3}, from the description {0}."
description: |
  Joints of `position`, `velocity`, `torque` in this order: {4}.
  Links that fixed joints hold together are one body, called by the first of them. Poses are those of the centre of
  mass, turned as seen from the position in which all joints are at 0. An actuator that no connection names does
  nothing; name one of them.
{6})",
        gen::in_json_string(robot_.file), robot_.id,
        gen::counted(robot_.bodies.size(), "body", "bodies"),
        gen::counted(joints_.size(), "joint", "joints"), joints_.empty() ? "none" : names(joints_),
        gen::in_comment(robot_.file), followers() + driven() + keyframes());
  }

  std::string followers() const {
    std::string text;
    for (const BodyJoint& joint : robot_.joints) {
      if (!joint.mimics.empty())
        text += fmt::format("  `{}` follows `{}`: {} times its position, plus {}.\n", joint.name,
                            joint.mimics, gen::double_literal(joint.ratio + 0.0),
                            gen::double_literal(joint.offset + 0.0));
    }
    return text;
  }

  /// Which joints have actuators, where not all have.
  std::string driven() const {
    if (driven_.size() == joints_.size()) return {};
    if (driven_.empty()) return "  No joint has an actuator.\n";
    return fmt::format("  Actuators are those of {}.\n", names(driven_));
  }

  std::string keyframes() const {
    std::string text;
    for (const Keyframe& frame : robot_.keyframes) {
      const auto value = [&](const BodyJoint& joint) {
        const auto known = frame.positions.find(joint.name);
        return known != frame.positions.end() ? known->second : 0.0;
      };
      text += fmt::format("  Positions `{}` of the description: [{}].\n", frame.name,
                          numbers(joints_, value));
    }
    return text;
  }

  std::string config() const {
    std::string text = R"(config:
  origin: {type: floats, unit: m, default: [0.0, 0.0, 0.0], about: "where the frame of the first link is in the world"}
  touches_itself: {type: bool, default: false, about: "its own bodies collide, but for those that a joint connects"}
  friction: {type: float, default: 1.0, low: 0.0, about: "coefficient of friction of all its shapes; that of a contact is the product of both"}
  bounce: {type: float, default: 0.0, low: 0.0, high: 1.0, about: share of the normal speed that is left after a contact}
)";
    if (driven_.empty()) return text;
    double most = 0.0;
    for (const BodyJoint& joint : driven_)
      most = std::max(most, or_else(joint.limits.effort, kAnything));
    return text + gains() +
           fmt::format(
               R"(  max_torque: {{type: float, default: {}, low: 0.0, about: "of the actuators `velocity` and `position`; a joint's own limit holds besides [N*m, N]"}}
)",
               gen::double_literal(most));
  }

  /// Whether the description says what a servo of a joint is.
  bool has_servos() const {
    return std::ranges::any_of(
        driven_, [](const BodyJoint& j) { return j.limits.drive.stiffness.has_value(); });
  }

  std::string gains() const {
    constexpr double kStiffness = 100.0, kDamping = 5.0;
    if (!has_servos())
      return fmt::format(
          R"(  stiffness: {{type: float, default: {}, low: 0.0, about: "of the actuator `position`, for each rad or m [N*m/rad, N/m]"}}
  damping: {{type: float, default: {}, low: 0.0, about: "of the actuator `position`, for each rad/s or m/s [N*m*s/rad, N*s/m]"}}
)",
          gen::double_literal(kStiffness), gen::double_literal(kDamping));
    const auto stiffness = [&](const BodyJoint& j) {
      return j.limits.drive.stiffness.value_or(kStiffness);
    };
    const auto damping = [&](const BodyJoint& j) {
      return j.limits.drive.stiffness ? j.limits.drive.damping : kDamping;
    };
    return fmt::format(
        R"(  stiffnesses: {{type: floats, default: [{}], about: "of the actuator `position`, of each joint [N*m/rad, N/m]"}}
  dampings: {{type: floats, default: [{}], about: "of the actuator `position`, of each joint [N*m*s/rad, N*s/m]"}}
)",
        numbers(driven_, stiffness), numbers(driven_, damping));
  }

  void sensor(const std::string& name, const std::string& space, const std::string& about,
              const std::string& type) {
    sensors_ +=
        fmt::format("  {}: {{rate: {}, space: {}, about: \"{}\"}}\n", name, kRate, space, about);
    nodes_ += fmt::format("      {0}: {{type: {1}, rate: $(sensors {0} rate)", name, type);
    connections_ += fmt::format("      - {{from: {0}.observation, to: sensors.{0}}}\n", name);
  }
  /// Ends the node that sensor() began.
  void configured(const std::string& config) {
    nodes_ += fmt::format(", config: {{{}}}}}\n", config);
  }

  /// `in_open_dynamics` is the type on OpenDynamicsEngine, if it is another one.
  void state(const std::string& name, const std::string& space, const std::string& about,
             const std::string& type, const std::string& in_open_dynamics = {}) {
    states_ += fmt::format("  {}: {{space: {}, about: \"{}\"}}\n", name, space, about);
    multibody_states_ += fmt::format("      {}: {{type: {}}}\n", name, type);
    open_dynamics_states_ += fmt::format("      {}: {{type: {}}}\n", name,
                                         in_open_dynamics.empty() ? type : in_open_dynamics);
  }

  static std::string space_of(const std::vector<BodyJoint>& joints, const std::string& low,
                              const std::string& high) {
    return fmt::format("{{dtype: float32, shape: [{}], low: {}, high: {}}}", joints.size(), low,
                       high);
  }

  void add_joints() {
    const std::string anything = space_of(joints_, "-999.0", "999.0");
    const std::string config =
        fmt::format("joints: {}, size: {}", yaml_names(joints_), joints_.size());
    sensor("position", anything, "of all joints, in rad and m; not wrapped", "JointPositionSensor");
    configured(config);
    sensor("velocity", anything, "of all joints, in rad/s and m/s", "JointVelocitySensor");
    configured(config);
    sensor("torque", anything, "of all joints in the engine's last step, in N*m and N",
           "JointTorqueSensor");
    configured(config);
    if (!driven_.empty()) add_actuators();
    const auto slow = [](const BodyJoint& j) { return std::min(j.limits.velocity, 1.0); };
    const auto slow_back = [](const BodyJoint& j) { return -std::min(j.limits.velocity, 1.0); };
    state("model_state",
          fmt::format("{{dtype: float32, shape: [{}], low: [{}, {}], high: [{}, {}]}}",
                      2 * joints_.size(), numbers(joints_, low), numbers(joints_, slow_back),
                      numbers(joints_, high), numbers(joints_, slow)),
          "positions of all joints in rad and m, then their velocities",
          fmt::format("JointState, config: {{joints: {}}}", yaml_names(joints_)));
  }

  void add_actuators() {
    const auto most = [](const BodyJoint& j) { return or_else(j.limits.effort, kAnything); };
    actuator(
        "torque", "JointTorqueActuator", "",
        [&](const BodyJoint& j) { return or_else(j.limits.drive.torque_low, -most(j)); },
        [&](const BodyJoint& j) { return or_else(j.limits.drive.torque_high, most(j)); },
        "of all joints, in N*m and N");
    const auto fast = [](const BodyJoint& j) { return or_else(j.limits.velocity, kAnything); };
    actuator(
        "velocity", "JointMotorActuator", ", max_torque: $(config max_torque)",
        [&](const BodyJoint& j) { return -fast(j); }, fast, "of all joints, in rad/s and m/s");
    actuator(
        "position", "JointPositionActuator",
        has_servos() ? ", stiffness: 0.0, damping: 0.0, stiffnesses: $(config stiffnesses), "
                       "dampings: $(config dampings), max_torque: $(config max_torque)"
                     : ", stiffness: $(config stiffness), damping: $(config damping), "
                       "max_torque: $(config max_torque)",
        [](const BodyJoint& j) { return or_else(j.limits.drive.position_low, low(j)); },
        [](const BodyJoint& j) { return or_else(j.limits.drive.position_high, high(j)); },
        "of all joints, in rad and m");
    const std::string driven = fmt::format("config: {{joints: {}}}", yaml_names(driven_));
    state("strength",
          fmt::format("{{dtype: float32, shape: [{}], low: 0.9, high: 1.1}}", driven_.size()),
          "factor on the torque of each actuator", "JointStrength, " + driven);
    state("gains", "{dtype: float32, shape: [2], low: 0.9, high: 1.1}",
          "factors on stiffness and damping of the actuator `position`", "JointGains, " + driven);
  }

  template <class Low, class High>
  void actuator(const char* name, const char* type, const char* config, const Low& low,
                const High& high, const char* about) {
    actuators_ += fmt::format("  {}: {{rate: {}, space: {}, about: \"{}\"}}\n", name, kRate,
                              space_of(driven_, fmt::format("[{}]", numbers(driven_, low)),
                                       fmt::format("[{}]", numbers(driven_, high))),
                              about);
    nodes_ += fmt::format(
        "      {0}_actuator: {{type: {1}, rate: $(actuators {0} rate), config: {{joints: {2}, "
        "default_action: [{3}]{4}}}}}\n",
        name, type, yaml_names(driven_), numbers(driven_, [](const BodyJoint&) { return 0.0; }),
        config);
    connections_ += fmt::format("      - {{from: actuators.{0}, to: {0}_actuator.action}}\n", name);
  }

  void add_body(const Body& body) {
    const std::string config = "body: " + gen::yaml_text(body.name);
    sensor(body.name + "_pose", "{dtype: float32, shape: [7], low: -999.0, high: 999.0}",
           "[x, y, z] in m and quaternion [qw, qx, qy, qz]", "BodyPoseSensor");
    configured(config);
    sensor(body.name + "_twist", "{dtype: float32, shape: [6], low: -999.0, high: 999.0}",
           "[vx, vy, vz] in m/s, [wx, wy, wz] in rad/s", "BodyTwistSensor");
    configured(config);
    sensor(body.name + "_imu", "{dtype: float32, shape: [6], low: -9999.0, high: 9999.0}",
           "specific force in m/s^2, angular velocity in rad/s, in the axes of the body",
           "ImuSensor");
    configured(config);
    state(body.name + "_mass",
          fmt::format("{{dtype: float32, shape: [], low: {}, high: {}}}",
                      gen::double_literal(0.5 * body.mass), gen::double_literal(2.0 * body.mass)),
          "in kg; the inertia goes with it", fmt::format("BodyMass, config: {{{}}}", config));
    if (!body.is_free) return;
    state(body.name + "_start",
          "{dtype: float32, shape: [7], low: [-1.0, -1.0, 0.0, -1.0, -1.0, -1.0, -1.0], high: 1.0}",
          "pose as the sensor gives it, the quaternion with any length",
          fmt::format("BodyPose, config: {{{}}}", config));
    state(body.name + "_speed", "{dtype: float32, shape: [6], low: -1.0, high: 1.0}",
          "twist as the sensor gives it", fmt::format("BodyTwist, config: {{{}}}", config));
    state(body.name + "_center_of_mass", "{dtype: float32, shape: [3], low: -0.02, high: 0.02}",
          "offset of the center of mass from the description's in m, on MultibodyEngine",
          fmt::format("BodyCenterOfMass, config: {{{}}}", config), "DummyState");
    add_force(body.name, config);
    add_heights(body);
  }

  void add_force(const std::string& name, const std::string& config) {
    const std::string port = name + "_force";
    actuators_ += fmt::format(
        "  {}: {{rate: {}, space: {{dtype: float32, shape: [3], low: -999.0, high: 999.0}}, about: "
        "\"a push in the center of mass, in N in the axes of the world\"}}\n",
        port, kRate);
    nodes_ += fmt::format(
        "      {0}: {{type: BodyForceActuator, rate: $(actuators {0} rate), config: {{{1}}}}}\n",
        port, config);
    connections_ += fmt::format("      - {{from: actuators.{0}, to: {0}.action}}\n", port);
  }

  /// Of a free body and of the joints above the ground.
  void add_heights(const Body& free) {
    sensor(free.name + "_height", "{dtype: float32, shape: [1], low: -999.0, high: 999.0}",
           "of the center of mass above the ground, in m", "HeightSensor");
    configured("bodies: " + gen::yaml_text(free.name));
    if (joints_.empty() || has_heights_) return;
    has_heights_ = true;
    std::string bodies, points;
    for (const BodyJoint& joint : joints_) {
      const auto child = std::ranges::find(robot_.bodies, joint.child, &Body::name);
      const Vector3 arm = joint.anchor - child->position;
      bodies += (bodies.empty() ? "" : " ") + joint.child;
      for (const double x : {arm[0], arm[1], arm[2]})
        points +=
            (points.empty() ? "" : ", ") + gen::double_literal(std::round(1e6 * x) / 1e6 + 0.0);
    }
    sensor("joint_heights", space_of(joints_, "-999.0", "999.0"),
           "of all joints above the ground, in m", "HeightSensor");
    configured(fmt::format("bodies: {}, size: {}, points: [{}]",
                           joints_.size() == 1 ? gen::yaml_text(bodies) : bodies, joints_.size(),
                           points));
  }

  /// Of all shapes in one message.
  void add_contacts() {
    std::string names;
    std::size_t count = 0;
    for (const Shape& shape : robot_.shapes) {
      if (shape.body.empty()) continue;
      names += (count++ == 0 ? "" : " ") + shape.name;
    }
    if (count == 0) return;
    sensor("contacts", fmt::format("{{dtype: float32, shape: [{}], low: 0.0, high: 1.0}}", count),
           "1 for each shape that something touches: " + names, "ContactSensor");
    configured(
        fmt::format("geometries: {}, size: {}", count == 1 ? gen::yaml_text(names) : names, count));
  }

  void add_contact(const std::string& shape) {
    sensor(shape + "_contact", "{dtype: float32, shape: [3], low: -99999.0, high: 99999.0}",
           "force of all that touches it, in N", "ContactForceSensor");
    configured("geometry: " + gen::yaml_text(shape));
  }

  void add_scene() {
    const std::size_t rows = std::min<std::size_t>(2 + robot_.facets.size() + robot_.shapes.size() +
                                                       robot_.joints.size() + robot_.bodies.size(),
                                                   kMostRows);
    const Camera camera = camera_of(robot_);
    const std::string follow =
        camera.follow.empty() ? "" : ", follow: " + gen::yaml_text(camera.follow);
    const auto rounded = [](Vector3 v) {
      for (std::size_t i = 0; i < 3; ++i) v[i] = std::round(1e3 * v[i]) / 1e3;
      return vector_text(v);
    };
    sensors_ += fmt::format(
        "  scene: {{rate: {}, space: {{dtype: float32, shape: [{}, 16]}}, about: \"drawing of the "
        "robot\"}}\n",
        kRate, rows);
    nodes_ += fmt::format(
        "      scene: {{type: RigidDrawing, rate: $(sensors scene rate), config: {{rows: {}, eye: "
        "{}, target: {}{}}}}}\n",
        rows, rounded(camera.eye), rounded(camera.target), follow);
    connections_ += "      - {from: scene.scene, to: sensors.scene}\n";
  }

  std::string engines() const {
    return "engines:\n" +
           (can_use_open_dynamics(robot_) ? engine("OpenDynamicsEngine", "", open_dynamics_states_)
                                          : "") +
           (can_use_multibody(robot_)
                ? engine("MultibodyEngine", ", vectorized: true", multibody_states_)
                : "");
  }
  std::string engine(const char* name, const char* more, const std::string& states) const {
    return fmt::format(
        "  {5}:\n    model: {{header: {0}.hpp, class: \"eagerx::models::{1}\"{6}}}\n    nodes:\n{2}"
        "    connections:\n{3}    states:\n{4}",
        robot_.name, robot_.id, nodes_, connections_, states, name, more);
  }

  const Robot& robot_;
  std::vector<BodyJoint> joints_;  // that move, without those that follow another one
  std::vector<BodyJoint> driven_;  // that have actuators
  std::string sensors_, actuators_, states_, nodes_, connections_;
  std::string multibody_states_, open_dynamics_states_;
  bool has_heights_ = false;
};

}  // namespace

std::string manifest_text(const Robot& robot) {
  return Manifest(robot).text();
}

}  // namespace eagerx::urdf
