// A description in the form that OpenDynamicsEngine needs: bodies, joints and shapes in one frame.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "generator/urdf/urdf.hpp"

namespace eagerx::urdf {

enum class Base : std::uint8_t { by_mass, fixed, free };

struct RobotOptions {
  std::string id;             // of the object; empty: from the robot's name
  Base base = Base::by_mass;  // the first link, with what is fixed to it, is free if it has a mass
  bool ground = false;        // add the plane z = 0 of the world
};

/// Links that fixed joints hold together, as one body. Fields as in RigidBody.
struct Body {
  std::string name;  // of the first link
  gen::Span place;
  double mass = 0.0;
  Vector3 position{};
  Vector3 inertia{}, products{};
  bool is_free = false;  // no joint holds it
  bool is_made = false;  // it stands between two axes of one joint, and has nothing of its own
  double share = 1e-3;   // of the robot's mass, if it has none
};

/// Fields as in RigidJoint.
struct BodyJoint {
  std::string name;
  bool slides = false;    // else it turns
  bool is_fixed = false;  // else it moves
  std::string parent;     // empty: the world
  std::string child;
  Vector3 anchor{}, axis{};
  Joint limits;        // of the description
  std::string mimics;  // a joint that this one follows: ratio · its position + offset
  double ratio = 1.0, offset = 0.0;
};

/// Fields as in RigidGeometry.
struct Shape {
  std::string name;
  models::ShapeKind kind = models::ShapeKind::sphere;
  std::string body;  // empty: the world
  Vector3 size{}, position{};
  Quaternion rotation{};
  Vector3 normal{};       // of a plane
  double friction = 1.0;  // times that of the object
};

/// Fields as in RigidFacet.
struct Facet {
  std::string body;  // empty: the world
  std::array<Vector3, 3> corners{};
};

/// All names are made of letters, digits and `_`.
struct Robot {
  std::string file;
  std::string id;         // "TwoLinkArm"
  std::string name;       // "two_link_arm"
  std::string base;       // the first link
  std::size_t links = 0;  // of the description
  std::vector<Body> bodies;
  std::vector<BodyJoint> joints;  // parents first
  std::vector<Shape> shapes;
  std::vector<Facet> facets;
  std::vector<std::array<std::string, 2>> pairs;  // of shapes that touch each other
  bool ground = false;
  bool has_world = false;  // the description says itself what is free
  Vector3 gravity{{0.0, 0.0, -9.81}};
  std::vector<Keyframe> keyframes;  // by the names of `joints`
};

/// Problems: E0854 (names), E0855 (the links are no tree), E0856 (masses that no body has), E0859
/// (`mimic`).
std::optional<Robot> make_robot(const Description& description, const RobotOptions& options,
                                gen::Diagnostics& diagnostics);

/// One tree, on the world or of a free body, and one plane at most.
bool can_use_multibody(const Robot& robot);
/// No joint follows another one.
bool can_use_open_dynamics(const Robot& robot);

/// The joint that reaches its limit of speed first from rest, under its largest torque, as far as
/// the body that it moves says.
struct QuickJoint {
  std::string name;
  double time_s = 0.0;
  double speed = 0.0;  // [rad/s, m/s]
};
std::optional<QuickJoint> quickest_joint(const Robot& robot);

/// The object's header and its manifest.
std::string header_text(const Robot& robot);
std::string manifest_text(const Robot& robot);

/// A view of all of a robot, from the front, the right and above [m].
struct Camera {
  Vector3 eye, target;  // about the horizontal position of `follow`, if there is one
  std::string follow;   // the free body, or empty
};
Camera camera_of(const Robot& robot);

}  // namespace eagerx::urdf
