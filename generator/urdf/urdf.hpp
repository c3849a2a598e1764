// The typed contents of a robot's URDF or MJCF file.
#pragma once

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/support/diagnostics/diagnostics.hpp"
#include "models/engines/open_dynamics_engine/scene.hpp"

namespace eagerx::urdf {

using models::dot;
using models::product;
using models::Quaternion;
using models::rotate;
using models::Vector3;
using models::operator+;
using models::operator-;
using models::operator*;

/// A frame in another one.
struct Frame {
  Vector3 position{};                         // [m]
  Quaternion rotation{{1.0, 0.0, 0.0, 0.0}};  // of length 1
};

/// `inner` is given in `outer`.
inline Frame operator*(const Frame& outer, const Frame& inner) {
  return {outer.position + rotate(outer.rotation, inner.position),
          models::normalised(product(outer.rotation, inner.rotation))};
}

struct Inertial {
  Frame origin;        // of the centre of mass, in the link's frame
  double mass = 0.0;   // [kg]
  Vector3 inertia{};   // Ixx, Iyy, Izz about the axes of `origin` [kg·m²]
  Vector3 products{};  // Ixy, Ixz, Iyz
};

/// The share of the robot's mass for a massless link between two axes of one body.
inline constexpr double kSmallShare = 1e-9;

/// A file of triangles.
struct Mesh {
  std::string file;  // as the description writes it
  gen::Span place;
  Vector3 scale{{1.0, 1.0, 1.0}};
};

struct Collision {
  std::string name;  // may be empty
  gen::Span place;
  Frame origin;  // in the link's frame
  models::ShapeKind kind = models::ShapeKind::sphere;
  Vector3 size{};            // as RigidGeometry has it
  Vector3 normal{};          // of a plane
  std::optional<Mesh> mesh;  // until resolve_meshes()
  double friction = 1.0;     // times that of the object
};

/// How a link looks.
struct Visual {
  Mesh mesh;
  Frame origin;  // in the link's frame
};

struct Link {
  std::string name;
  gen::Span place;
  std::optional<Inertial> inertial;
  gen::Span inertial_place;
  std::vector<Collision> collisions;
  std::vector<Visual> visuals;
  std::vector<Vector3> look;  // corners of triangles, in the link's frame; from draw_meshes()
  bool is_made = false;       // between two axes of what the description has as one joint or body
  double share = 1e-3;        // of the robot's mass, if it can move and has no mass
};

enum class JointType : std::uint8_t {
  fixed,
  revolute,
  continuous,
  prismatic,
  floating,
  planar,    // until expand_joints()
  spherical  // of Bullet; until expand_joints()
};

/// The position is ratio · (position of `joint`) + offset.
struct Mimic {
  std::string joint;
  gen::Span place;
  double ratio = 1.0;
  double offset = 0.0;  // [rad, m]
};

/// Actuators of a joint in the description. Torques in N·m or N.
struct Drive {
  bool exists = true;
  double torque_low = -std::numeric_limits<double>::infinity();
  double torque_high = std::numeric_limits<double>::infinity();
  double position_low = -std::numeric_limits<double>::infinity();
  double position_high = std::numeric_limits<double>::infinity();
  std::optional<double> stiffness;  // of a servo [N·m/rad, N/m]
  double damping = 0.0;             // of the servo [N·m·s/rad, N·s/m]
};

/// Angles in rad, lengths in m, torques in N·m (revolute, continuous) or N (prismatic).
struct Joint {
  std::string name;
  gen::Span place;
  JointType type = JointType::fixed;
  std::string parent, child;  // links
  gen::Span parent_place, child_place;
  Frame origin;                   // of the child's frame in the parent's, at position 0
  Vector3 axis{{1.0, 0.0, 0.0}};  // of length 1, in the child's frame
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  double effort = std::numeric_limits<double>::infinity();    // largest torque
  double velocity = std::numeric_limits<double>::infinity();  // largest, in magnitude
  double damping = 0.0, friction = 0.0, armature = 0.0;
  double stiffness = 0.0, rest = 0.0;  // of a spring
  std::optional<Mimic> mimic;
  Drive drive;
};

/// A configuration that the description names, by the names of joints.
struct Keyframe {
  std::string name;
  std::map<std::string, double> positions;
};

/// Two collisions that touch each other, by their names.
struct TouchingPair {
  std::string first, second;
  gen::Span place;
};

struct Description {
  std::string file;  // its name, without folders
  std::string name;
  gen::Span place;
  std::vector<Link> links;
  std::vector<Joint> joints;
  // Of MJCF alone.
  bool has_world = false;  // the first link is the world
  std::optional<Vector3> gravity;
  std::vector<Keyframe> keyframes;
  std::vector<TouchingPair> pairs;
};

/// Reads the part of URDF that this library can simulate (http://wiki.ros.org/urdf/XML), or MJCF by
/// its own rules if the first element is `mujoco`: an unknown element that would change the motion
/// is an error; elements of other tools are left out with a note. Files of xacro are expanded by
/// the program `xacro`. Problems: E0101 to E0103, E0850 (no XML), E0851 (not supported), E0852
/// (missing), E0853 (not the number it should be), E0854 (names).
std::optional<Description> read_file(const std::string& path, gen::SourceMap& sources,
                                     gen::Diagnostics& diagnostics);
/// The same of a text.
std::optional<Description> read_text(const std::string& name, std::string text,
                                     gen::SourceMap& sources, gen::Diagnostics& diagnostics);

/// Fixes the robot to the world or frees it, in a description that has a world.
void set_base(Description& description, bool is_free);

/// Planar and spherical joints become sliders and hinges, with links between them that have no
/// mass.
void expand_joints(Description& description);

/// The output of the program `xacro` for a file. Problem: E0857.
std::optional<std::string> expand_xacro(const std::string& path, gen::Span place,
                                        gen::Diagnostics& diagnostics);

}  // namespace eagerx::urdf
