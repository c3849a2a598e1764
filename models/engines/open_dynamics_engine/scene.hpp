// Parts of an object on OpenDynamicsEngine: bodies, joints, geometries, known to the
// compiler.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <models/engines/open_dynamics_engine/rotation.hpp>

namespace eagerx::models {

/// A rigid body. All lengths in m and in the object's frame, where every body of the reference pose
/// has the axes of the frame.
struct RigidBody {
  const char* name = "";
  double mass = 1.0;                 // [kg]
  Vector3 inertia{{1.0, 1.0, 1.0}};  // about the body's axes through its centre of mass [kg·m²]
  Vector3 position{};                // of the centre of mass in the reference pose
  Vector3 products{};                // of inertia: Ixy, Ixz, Iyz, as in the matrix [kg·m²]
};

enum class JointKind : std::uint8_t {
  hinge,      // a rotation about `axis`
  slider,     // a translation along `axis`
  universal,  // rotations about `axis`, which the parent has, and then `axis2`, which the child has
  ball,
  fixed
};

/// A joint. Its positions are zero in the reference pose, and positive when the child moves along
/// or about the axis (right-handed). Joints make a tree: every body is the child of one joint at
/// most, and parents come first.
struct RigidJoint {
  const char* name = "";
  JointKind kind = JointKind::hinge;
  const char* parent = "";  // a body; empty: the world
  const char* child = "";
  Vector3 anchor{};               // a point of the joint in the reference pose
  Vector3 axis{{0.0, 1.0, 0.0}};  // of length 1
  Vector3 axis2{{0.0, 0.0, 1.0}};
  // Of hinge and slider: where the joint stops.
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  // Of hinge and slider, too.
  double max_torque = std::numeric_limits<double>::infinity();  // of all actuators [N·m, N]
  double damping = 0.0;   // torque against each rad/s [N·m·s/rad, N·s/m]
  double friction = 0.0;  // torque that holds the joint, and brakes it when it moves [N·m, N]
  // A spring: no torque at the position `rest` [rad, m].
  double stiffness = 0.0;  // torque against each rad [N·m/rad, N/m]
  double rest = 0.0;
  // Of hinge and slider on MultibodyEngine; OpenDynamicsEngine has neither.
  double armature = 0.0;  // inertia of the motor, times the square of its gear ratio [kg·m², kg]
  double max_velocity = std::numeric_limits<double>::infinity();  // [rad/s, m/s]
  // The name of a hinge or slider, which mimics none itself, on MultibodyEngine:
  // position = ratio · (position of that one) + offset.
  const char* mimics = "";
  double ratio = 1.0, offset = 0.0;  // [rad, m]
};

enum class ShapeKind : std::uint8_t {
  sphere,    // size: radius
  box,       // size: the three sides
  capsule,   // size: radius, length of the cylinder between the half spheres, along its z axis
  cylinder,  // size: radius, length along its z axis
  plane      // the half space below `position`, whose normal is `axis`; belongs to no body
};

/// A shape that touches others. Friction of a contact is the product of both frictions; it bounces
/// with the larger of both.
struct RigidGeometry {
  const char* name = "";
  ShapeKind kind = ShapeKind::sphere;
  const char* body = "";  // empty: the world
  Vector3 size{{1.0, 1.0, 1.0}};
  Vector3 position{};             // from the body's centre of mass, or in the object's frame
  Vector3 axis{{0.0, 0.0, 1.0}};  // normal of a plane
  double friction = 1.0;          // Coulomb's coefficient
  double bounce = 0.0;            // share of the normal speed that is left
  Quaternion rotation{{1.0, 0.0, 0.0, 0.0}};  // from the axes of body or frame; not of planes
};

/// A flat piece of a body as it looks: drawn instead of its geometries, and touched by nothing.
struct RigidFacet {
  const char* body = "";  // empty: the world
  // From the body's center of mass or in the object's frame [m], counterclockwise from outside; a
  // triangle repeats its last.
  std::array<std::array<float, 3>, 4> corners{};
};

/// Heights of the ground above a level plane [m]: bilinear between the points of a grid,
/// height[i][k] at corner + (i·spacing, k·spacing) of the object's frame; around the grid as at its
/// edge.
template <std::size_t X, std::size_t Y>
struct HeightField {
  static_assert(X >= 2 && Y >= 2, "a height field has at least two points along x and y");
  static constexpr std::size_t kX = X, kY = Y;
  double corner[2] = {0.0, 0.0};  // x, y [m]
  double spacing = 0.1;           // [m]
  std::array<std::array<float, Y>, X> height{};
};

namespace scene {

constexpr bool equal(const char* a, const char* b, std::size_t length_of_b) {
  for (std::size_t i = 0; i < length_of_b; ++i) {
    if (a[i] == '\0' || a[i] != b[i]) return false;
  }
  return a[length_of_b] == '\0';
}

constexpr std::size_t length(const char* text) {
  std::size_t i = 0;
  while (text[i] != '\0') ++i;
  return i;
}

/// Position of the item called `name`, or N.
template <class Item, std::size_t N>
constexpr std::size_t find(const std::array<Item, N>& items, const char* name, std::size_t size) {
  std::size_t i = 0;
  while (i < N && !equal(items[i].name, name, size)) ++i;
  return i;
}
template <class Item, std::size_t N>
constexpr std::size_t find(const std::array<Item, N>& items, const char* name) {
  return find(items, name, length(name));
}

/// f(first character, length) for each of the names, which blanks separate.
template <class F>
constexpr void for_each_name(const char* names, F&& f) {
  while (*names != '\0') {
    if (*names == ' ') {
      ++names;
      continue;
    }
    std::size_t size = 0;
    while (names[size] != '\0' && names[size] != ' ') ++size;
    f(names, size);
    names += size;
  }
}

constexpr std::size_t count_names(const char* names) {
  std::size_t count = 0;
  for_each_name(names, [&](const char*, std::size_t) { ++count; });
  return count;
}

/// Positions of the items that `names` lists; N for a name that no item has.
template <std::size_t Count, class Item, std::size_t N>
constexpr std::array<std::size_t, Count> find_all(const std::array<Item, N>& items,
                                                  const char* names) {
  std::array<std::size_t, Count> result{};
  std::size_t i = 0;
  for_each_name(names,
                [&](const char* name, std::size_t size) { result[i++] = find(items, name, size); });
  return result;
}

template <std::size_t Count>
constexpr bool all_below(const std::array<std::size_t, Count>& positions, std::size_t end) {
  for (const std::size_t position : positions) {
    if (position >= end) return false;
  }
  return true;
}

/// Whether every body that a joint or geometry names exists.
template <class Model>
constexpr bool bodies_exist() {
  constexpr std::size_t kCount = Model::kBodies.size();
  for (const auto& joint : Model::kJoints) {
    if (find(Model::kBodies, joint.child) == kCount) return false;
    if (*joint.parent != '\0' && find(Model::kBodies, joint.parent) == kCount) return false;
  }
  for (const auto& geometry : Model::kGeometries) {
    if (*geometry.body != '\0' && find(Model::kBodies, geometry.body) == kCount) return false;
  }
  return true;
}

/// Whether the joints are a tree in an order in which parents come first.
template <class Model>
constexpr bool is_tree() {
  constexpr std::size_t kCount = Model::kBodies.size();
  std::array<bool, kCount + 1> is_child{};
  std::array<bool, kCount + 1> is_parent{};
  for (const auto& joint : Model::kJoints) {
    const std::size_t child = find(Model::kBodies, joint.child);
    if (is_child[child] || is_parent[child]) return false;
    is_child[child] = true;
    if (*joint.parent != '\0') is_parent[find(Model::kBodies, joint.parent)] = true;
  }
  return true;
}

/// The first plane, or the number of geometries.
template <class Model>
constexpr std::size_t find_plane() {
  std::size_t g = 0;
  while (g < Model::kGeometries.size() && Model::kGeometries[g].kind != ShapeKind::plane) ++g;
  return g;
}
/// Whether heights, if there are some, are above a level plane.
template <class Model>
constexpr bool has_level_plane_for_heights() {
  if constexpr (requires { Model::kHeights; }) {
    constexpr std::size_t kPlane = find_plane<Model>();
    if constexpr (kPlane < Model::kGeometries.size())
      return Model::kGeometries[kPlane].axis[2] == 1.0;
    return false;
  }
  return true;
}

/// Whether a joint follows another one.
template <class Model>
constexpr bool has_mimics() {
  for (const auto& joint : Model::kJoints) {
    if (*joint.mimics != '\0') return true;
  }
  return false;
}

/// Whether a joint holds the body.
template <class Model>
constexpr bool is_child(std::size_t body) {
  for (const auto& joint : Model::kJoints) {
    if (find(Model::kBodies, joint.child) == body) return true;
  }
  return false;
}

}  // namespace scene

/// The model of an object for OpenDynamicsEngine: a class template over the object's Io with
///   using Real = …;
///   static constexpr std::array<RigidBody, …> kBodies;          // at least one
///   static constexpr std::array<RigidJoint, …> kJoints;
///   static constexpr std::array<RigidGeometry, …> kGeometries;
/// and, where it has some,
///   static constexpr Vector3 kOrigin;           // of the object's frame in the world
///   static constexpr bool kTouchesItself;       // its own bodies collide (default: not)
///   static constexpr std::array<std::array<const char*, 2>, …> kPairs;  // spheres and capsules
///   that
///                                               // touch each other, on MultibodyEngine
///   static constexpr std::array<RigidFacet, …> kFacets;  // how bodies look
///   static constexpr HeightField<…> kHeights;   // what the first plane has on it
///   static constexpr std::size_t kInputs;       // numbers that ModelInput sets
///   static constexpr std::size_t kParameters;   // numbers that ModelParameters sets, with
///   static constexpr Array<double, kParameters> default_parameters();
///   template <class S> static void configure(S& simulator);  // parameters → masses, anchors
///   template <class S> static void actuate(S& simulator);    // before each step: torques
/// `simulator` is an OpenDynamicsSimulator. Positions and names are known to the compiler.
template <class Model>
concept RigidModel = (Model::kBodies.size() > 0) && requires {
  Model::kJoints.size();
  Model::kGeometries.size();
};

}  // namespace eagerx::models
