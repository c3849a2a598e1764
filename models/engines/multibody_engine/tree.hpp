// The tree of links that MultibodyEngine computes with, made from an object's description
// (scene.hpp of OpenDynamicsEngine) at compile time.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <models/engines/open_dynamics_engine/scene.hpp>

namespace eagerx::models::multibody {

// In addition to the operators of spatial.hpp.
using models::operator+;
using models::operator-;

/// The base in lists of links, the world in lists of bodies.
inline constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
/// A direction that is not an axis of the object's frame.
inline constexpr std::size_t kTurned = 3;

/// Mass, first moment and inertia of a body about a point: [m, hx, hy, hz, Ixx, Iyy, Izz, Ixy, Ixz,
/// Iyz] in kg, kg·m, kg·m², products as in the matrix.
using InertiaAbout = std::array<double, 10>;

constexpr InertiaAbout inertia_about(const RigidBody& body, const Vector3& c) {
  const double m = body.mass;
  return {m,
          m * c[0],
          m * c[1],
          m * c[2],
          body.inertia[0] + m * (c[1] * c[1] + c[2] * c[2]),
          body.inertia[1] + m * (c[0] * c[0] + c[2] * c[2]),
          body.inertia[2] + m * (c[0] * c[0] + c[1] * c[1]),
          body.products[0] - m * c[0] * c[1],
          body.products[1] - m * c[0] * c[2],
          body.products[2] - m * c[1] * c[2]};
}

/// A link: the bodies that one hinge or slider moves, welded together. All vectors are in the axes
/// of the object's frame, which every link has in the reference pose.
struct Link {
  std::size_t joint = 0;       // in the model's kJoints
  std::size_t parent = kNone;  // a link
  std::size_t limb = 0;        // the position of the link on the base that it hangs on
  bool slides = false;
  std::size_t axis = kTurned;
  Vector3 direction{};  // of the axis; with `axis` below kTurned that axis itself, not its opposite
  double sign = 1.0;    // coordinate of the link = sign * position of the joint
  Vector3 position{};   // of the joint, from the parent's joint or the base's reference point
  Vector3 anchor{};     // of the joint, in the object's frame
};

/// Where a geometry touches a plane: a sphere around a point of a link.
struct Point {
  std::size_t geometry = 0;
  std::size_t link = kNone;
  Vector3 position{};  // from the link's joint or the base's reference point
  double radius = 0.0;
  // A rim of a cylinder around `position`: the point is `phase` [rad] from its lowest one.
  double rim = 0.0, phase = 0.0;
  Vector3 axis{{0.0, 0.0, 1.0}}, across{{1.0, 0.0, 0.0}};
  bool solved = false;  // by the solver; else compliant
};

/// Links from `first` on: `count` limbs of `size` links each, of equal shape.
struct Group {
  std::size_t first = 0, size = 0, count = 0;
  std::size_t first_point = 0, points = 0;  // of each limb
};

template <class Model>
constexpr std::size_t parent_joint(std::size_t body) {
  for (std::size_t j = 0; j < Model::kJoints.size(); ++j) {
    if (scene::find(Model::kBodies, Model::kJoints[j].child) == body) return j;
  }
  return kNone;
}
constexpr bool moves(JointKind kind) {
  return kind == JointKind::hinge || kind == JointKind::slider;
}

/// Of the joints of a model.
template <class Model>
constexpr std::size_t count_moving() {
  std::size_t count = 0;
  for (const auto& joint : Model::kJoints) count += moves(joint.kind) ? 1 : 0;
  return count;
}
template <class Model>
constexpr bool has_only_trees_of_hinges() {
  for (const auto& joint : Model::kJoints) {
    if (!moves(joint.kind) && joint.kind != JointKind::fixed) return false;
  }
  return true;
}
/// Bodies without a joint.
template <class Model>
constexpr std::size_t count_free() {
  std::size_t count = 0;
  for (std::size_t b = 0; b < Model::kBodies.size(); ++b)
    count += parent_joint<Model>(b) == kNone ? 1 : 0;
  return count;
}
template <class Model>
constexpr std::size_t free_body() {
  std::size_t b = 0;
  while (parent_joint<Model>(b) != kNone) ++b;
  return b;
}
template <class Model>
constexpr bool hangs_on_world() {
  for (const auto& joint : Model::kJoints) {
    if (*joint.parent == '\0') return true;
  }
  return false;
}

constexpr std::size_t points_of(ShapeKind kind) {
  if (kind == ShapeKind::sphere) return 1;
  if (kind == ShapeKind::capsule) return 2;
  if (kind == ShapeKind::cylinder) return 6;
  return kind == ShapeKind::box ? 8 : 0;
}
/// The plane that everything of an object touches; as many as there are geometries if none.
template <class Model>
constexpr std::size_t find_plane() {
  return scene::find_plane<Model>();
}
template <class Model>
constexpr std::size_t count_planes() {
  std::size_t count = 0;
  for (const auto& geometry : Model::kGeometries) count += geometry.kind == ShapeKind::plane;
  return count;
}
template <class Model>
constexpr std::size_t count_points() {
  std::size_t count = 0;
  for (const auto& geometry : Model::kGeometries) {
    if (*geometry.body != '\0') count += points_of(geometry.kind);
  }
  return count_planes<Model>() == 0 ? 0 : count;
}

/// Pairs of geometries of an object that touch each other.
template <class Model>
constexpr std::size_t count_pairs() {
  if constexpr (requires { Model::kPairs; }) return Model::kPairs.size();
  return 0;
}

/// Point `i` of a geometry, from the geometry's centre and in its axes. A cylinder has three on
/// each rim: the lowest, which goes around when it rolls, and two on which it stands.
constexpr Point point_of(const RigidGeometry& geometry, std::size_t i) {
  const Vector3& s = geometry.size;
  const auto side = [&](std::size_t bit) { return (i >> bit & 1U) != 0 ? 0.5 : -0.5; };
  constexpr double kThird = 2.0943951023931953;  // of a turn
  Point point;
  if (geometry.kind == ShapeKind::box) {
    point.position = {{side(0) * s[0], side(1) * s[1], side(2) * s[2]}};
  } else if (geometry.kind == ShapeKind::cylinder) {
    point.position = {{0.0, 0.0, (i < 3 ? -0.5 : 0.5) * s[1]}};
    point.rim = s[0];
    point.phase = static_cast<double>(i % 3) * kThird;
  } else {
    point.radius = s[0];
    if (geometry.kind == ShapeKind::capsule) point.position[2] = side(0) * s[1];
  }
  point.axis = rotate(geometry.rotation, point.axis);
  point.across = rotate(geometry.rotation, point.across);
  point.position = geometry.position + rotate(geometry.rotation, point.position);
  return point;
}

/// The result of tree_of().
template <std::size_t Bodies, std::size_t Links, std::size_t Points>
struct TreeData {
  std::array<Link, Links> links{};
  std::array<std::size_t, Bodies> link_of_body{};
  std::array<Vector3, Bodies> place_of_body{};  // from the link's joint or the reference point
  std::array<Point, Points> points{};
  std::array<Group, Links> groups{};
  std::size_t group_count = 0;
  std::size_t limb_points = 0;  // the points of the base are the last ones
  Vector3 reference{};          // the base's reference point in the object's frame
};

namespace detail {

constexpr bool is_near(double a, double b) {
  return a - b < 1e-9 && b - a < 1e-9;
}

/// Axis and sign of a link from the direction of its joint.
constexpr void set_direction(Link& link, const Vector3& direction) {
  link.direction = direction;
  for (std::size_t i = 0; i < 3; ++i) {
    for (const double sign : {1.0, -1.0}) {
      if (!is_near(direction[i], sign)) continue;
      link.axis = i;
      link.sign = sign;
      link.direction = {};
      link.direction[i] = 1.0;
    }
  }
}

/// The joint that moves the body of a joint's `child`: itself, or through fixed joints one above.
template <class Model>
constexpr std::size_t moving_joint(std::size_t body) {
  std::size_t j = parent_joint<Model>(body);
  while (j != kNone && !moves(Model::kJoints[j].kind)) {
    const char* const parent = Model::kJoints[j].parent;
    j = *parent == '\0' ? kNone : parent_joint<Model>(scene::find(Model::kBodies, parent));
  }
  return j;
}
/// The joint that moves the parent of a joint.
template <class Model>
constexpr std::size_t joint_above(std::size_t joint) {
  const char* const parent = Model::kJoints[joint].parent;
  return *parent == '\0' ? kNone : moving_joint<Model>(scene::find(Model::kBodies, parent));
}
/// The joint on the base that carries a joint.
template <class Model>
constexpr std::size_t limb_of(std::size_t joint) {
  while (joint_above<Model>(joint) != kNone) joint = joint_above<Model>(joint);
  return joint;
}

/// Links limb by limb, each with its parents first.
template <class Model, class Tree>
constexpr void add_links(Tree& tree) {
  constexpr std::size_t kJoints = Model::kJoints.size();
  std::array<std::size_t, kJoints + 1> link_of_joint{};
  std::size_t next = 0;
  for (std::size_t root = 0; root < kJoints; ++root) {
    for (std::size_t j = root; j < kJoints; ++j) {
      if (!moves(Model::kJoints[j].kind) || limb_of<Model>(j) != root) continue;
      Link& link = tree.links[next];
      link_of_joint[j] = next++;
      link.joint = j;
      link.slides = Model::kJoints[j].kind == JointKind::slider;
      link.anchor = Model::kJoints[j].anchor;
      set_direction(link, Model::kJoints[j].axis);
      const std::size_t above = joint_above<Model>(j);
      if (above != kNone) link.parent = link_of_joint[above];
      link.limb = link_of_joint[root];
      const Vector3 from = above != kNone ? Model::kJoints[above].anchor : tree.reference;
      link.position = Model::kJoints[j].anchor - from;
    }
  }
  for (std::size_t b = 0; b < Model::kBodies.size(); ++b) {
    const std::size_t j = moving_joint<Model>(b);
    tree.link_of_body[b] = j == kNone ? kNone : link_of_joint[j];
    const Vector3 from = j == kNone ? tree.reference : Model::kJoints[j].anchor;
    tree.place_of_body[b] = Model::kBodies[b].position - from;
  }
}

/// Whether no link hangs on it: feet and hands, and a base without limbs.
template <class Tree>
constexpr bool is_last(const Tree& tree, std::size_t link) {
  for (const Link& other : tree.links) {
    if (other.parent == link) return false;
  }
  return true;
}

template <class Model, class Tree>
constexpr void add_points_of(Tree& tree, std::size_t link, std::size_t& next) {
  if constexpr (count_planes<Model>() > 0) {
    for (std::size_t g = 0; g < Model::kGeometries.size(); ++g) {
      const RigidGeometry& geometry = Model::kGeometries[g];
      if (*geometry.body == '\0') continue;
      const std::size_t body = scene::find(Model::kBodies, geometry.body);
      if (tree.link_of_body[body] != link) continue;
      for (std::size_t i = 0; i < points_of(geometry.kind); ++i) {
        Point& point = tree.points[next++];
        point = point_of(geometry, i);
        point.geometry = g;
        point.link = link;
        point.position = tree.place_of_body[body] + point.position;
        point.solved = is_last(tree, link);
      }
    }
  }
}
template <class Tree>
constexpr std::size_t count_points_of(const Tree& tree, std::size_t link) {
  std::size_t count = 0;
  for (const Point& point : tree.points) count += point.link == link ? 1 : 0;
  return count;
}
template <class Model>
constexpr std::size_t count_parts(std::size_t joint) {
  std::size_t count = 0;
  for (std::size_t b = 0; b < Model::kBodies.size(); ++b)
    count += moving_joint<Model>(b) == joint ? 1 : 0;
  return count;
}

/// Whether `size` links from `a` on and from `b` on are the same but for numbers.
template <class Model, class Tree>
constexpr bool are_alike(const Tree& tree, std::size_t a, std::size_t b, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    const Link &one = tree.links[a + i], &other = tree.links[b + i];
    if (one.slides != other.slides || one.axis != other.axis) return false;
    if (one.parent == kNone ? other.parent != kNone : other.parent != one.parent + b - a)
      return false;
    if (count_parts<Model>(one.joint) != count_parts<Model>(other.joint)) return false;
    if (count_points_of(tree, a + i) != count_points_of(tree, b + i)) return false;
  }
  return true;
}
template <class Tree>
constexpr std::size_t limb_size(const Tree& tree, std::size_t first) {
  std::size_t size = 0;
  while (first + size < tree.links.size() && tree.links[first + size].limb == first) ++size;
  return size;
}

/// Neighbouring limbs of equal shape are computed in one loop.
template <class Model, class Tree>
constexpr void add_groups(Tree& tree) {
  std::size_t points = 0;
  for (std::size_t first = 0; first < tree.links.size();) {
    Group& group = tree.groups[tree.group_count++];
    group.first = first;
    group.size = limb_size(tree, first);
    group.first_point = points;
    for (std::size_t i = 0; i < group.size; ++i) group.points += count_points_of(tree, first + i);
    do {
      ++group.count;
      first += group.size;
    } while (first < tree.links.size() && limb_size(tree, first) == group.size &&
             are_alike<Model>(tree, group.first, first, group.size));
    points += group.count * group.points;
  }
}

}  // namespace detail

/// Links, points and groups of a model; names have been checked.
template <class Model>
constexpr auto tree_of() {
  TreeData<Model::kBodies.size(), count_moving<Model>(), count_points<Model>()> tree{};
  for (std::size_t b = 0; b < Model::kBodies.size(); ++b) {
    if (parent_joint<Model>(b) == kNone) tree.reference = Model::kBodies[b].position;
  }
  detail::add_links<Model>(tree);
  std::size_t points = 0;
  for (std::size_t link = 0; link < tree.links.size(); ++link)
    detail::add_points_of<Model>(tree, link, points);
  tree.limb_points = points;
  detail::add_points_of<Model>(tree, kNone, points);
  detail::add_groups<Model>(tree);
  return tree;
}

}  // namespace eagerx::models::multibody
