// Draws an object on OpenDynamicsEngine: its geometries, and rods along its links.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <eagerx/math.hpp>
#include <eagerx/rate.hpp>
#include <eagerx/scene.hpp>
#include <models/engines/open_dynamics_engine/rigid_joints.hpp>
#include <models/engines/open_dynamics_engine/scene.hpp>
#include <type_traits>

namespace eagerx::models {

/// Every tick: scene [rows, 16] := camera, ground and bodies at the time of the tick.
template <class Io>
class RigidDrawing {
 public:
  using Simulator = typename Io::Simulator;

  void reset(const typename Io::States& /*states*/, Simulator& /*simulator*/) {}

  void callback(const Tick& /*tick*/, const typename Io::Inputs& /*in*/, typename Io::Outputs& out,
                Simulator& simulator) {
    Writer scene(out.scene);
    add_camera(scene, simulator);
    for (std::size_t g = 0; g < Model::kGeometries.size(); ++g) add_geometry(scene, simulator, g);
    for (std::size_t j = 0; j < Model::kJoints.size(); ++j) add_link(scene, simulator, j);
    for (std::size_t b = 0; b < kBodies; ++b) {
      if (!has_geometry(b) && !is_rod_[b] && !has_facets(b)) add_box(scene, simulator, b);
    }
    if constexpr (requires { Model::kFacets; }) add_facets(scene, simulator);
    if constexpr (kHasHeights) add_heights(scene, simulator);
  }

 private:
  using Model = typename Simulator::Model;
  using Config = typename Io::Config;
  using Message = std::remove_cvref_t<decltype(Io::Outputs::scene)>;
  using Writer = SceneWriter<Message>;
  static constexpr std::size_t kBodies = Model::kBodies.size();
  static constexpr std::size_t kFollowed = scene::find(Model::kBodies, Config::follow);
  static_assert(kFollowed < kBodies || *Config::follow == '\0',
                "RigidDrawing: `follow` is not a body of the object's model");
  static constexpr bool kHasHeights = requires { Model::kHeights; };
  static constexpr std::uint32_t kGround = 0xdad6ca, kDarkGround = 0xc6c2b4;
  static constexpr std::array<std::uint32_t, 6> kColours = {0x4a78a8, 0xd98a35, 0x5c9a6b,
                                                            0xb5564a, 0x8069a8, 0x7a8288};

  static constexpr std::size_t body_of(const char* name) {
    return scene::find(Model::kBodies, name);
  }
  static constexpr bool has_geometry(std::size_t body) {
    for (const auto& geometry : Model::kGeometries) {
      if (body_of(geometry.body) == body && geometry.kind != ShapeKind::sphere) return true;
    }
    return false;
  }
  /// Of each facet.
  static constexpr auto kFacetBody = [] {
    if constexpr (requires { Model::kFacets; }) {
      std::array<std::size_t, Model::kFacets.size()> bodies{};
      for (std::size_t f = 0; f < bodies.size(); ++f) bodies[f] = body_of(Model::kFacets[f].body);
      return bodies;
    } else {
      return std::array<std::size_t, 0>{};
    }
  }();
  static constexpr auto kHasFacets = [] {
    std::array<bool, kBodies> has{};
    for (const std::size_t body : kFacetBody) {
      if (body < kBodies) has[body] = true;
    }
    return has;
  }();
  static constexpr bool has_facets(std::size_t body) { return body < kBodies && kHasFacets[body]; }
  /// Whether a joint turns the body about a point that is not its centre of mass.
  static constexpr auto is_rod_ = [] {
    std::array<bool, kBodies> rods{};
    for (const auto& joint : Model::kJoints) {
      const std::size_t child = body_of(joint.child);
      if (joint.kind == JointKind::slider || joint.kind == JointKind::fixed) continue;
      for (std::size_t i = 0; i < 3; ++i)
        rods[child] = rods[child] || joint.anchor[i] != Model::kBodies[child].position[i];
    }
    return rods;
  }();
  static constexpr double kThickness = [] {  // of rods: a part of the longest [m]
    double longest = 0.0;
    for (const auto& joint : Model::kJoints) {
      const Vector3 arm = Model::kBodies[body_of(joint.child)].position - joint.anchor;
      longest = eagerx::max(longest, dot(arm, arm));
    }
    return 0.12 * eagerx::sqrt(longest);
  }();

  static constexpr Point3 point(const Vector3& v) {
    return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
  }
  static eagerx::Pose pose(const Vector3& at, const Quaternion& q) {
    return {point(at), static_cast<float>(q[0]), static_cast<float>(q[1]), static_cast<float>(q[2]),
            static_cast<float>(q[3])};
  }
  static constexpr std::uint32_t colour(std::size_t body) {
    return kColours[body % kColours.size()];
  }

  /// What the camera follows, in x and y.
  static Vector3 followed(Simulator& simulator) {
    Vector3 middle{};
    if constexpr (kFollowed < kBodies) middle = simulator.state(kFollowed).position;
    middle[2] = 0.0;
    return middle;
  }

  static void add_camera(Writer& scene, Simulator& simulator) {
    Vector3 middle = followed(simulator);
    if constexpr (kHasHeights) middle[2] = height(simulator, middle[0], middle[1]);
    const Vector3 eye{{Config::eye[0], Config::eye[1], Config::eye[2]}};
    const Vector3 target{{Config::target[0], Config::target[1], Config::target[2]}};
    scene.camera(point(middle + eye), point(middle + target), static_cast<float>(Config::angle),
                 0xe4ecf1);
    for (const auto& geometry : Model::kGeometries) {
      if (!kHasHeights && geometry.kind == ShapeKind::plane && geometry.axis[2] == 1.0)
        add_ground(scene, middle, geometry.position[2]);
    }
    if constexpr (Config::rail > 0.0) {
      for (const auto& joint : Model::kJoints) {
        if (joint.kind != JointKind::slider) continue;
        scene.segment(point(joint.anchor - Config::rail * joint.axis),
                      point(joint.anchor + Config::rail * joint.axis), stroke(0x9aa5ad, 0.03F));
      }
    }
  }

  /// Chequers stay where they are when the camera moves.
  static void add_ground(Writer& scene, const Vector3& middle, double z) {
    constexpr double kPair = 2.0 * Config::chequer;
    constexpr double kCells = 24.0;
    const auto snapped = [](double x) { return kPair * eagerx::floor(x / kPair); };
    scene.plane(point({{snapped(middle[0]), snapped(middle[1]), z}}),
                static_cast<float>(0.5 * kCells * Config::chequer),
                static_cast<float>(Config::chequer), kGround);
  }

  /// Of the ground in the world [m].
  static double height(const Simulator& simulator, double x, double y) {
    using Number = typename Simulator::Number;
    return -static_cast<double>(simulator.height_above_ground(
        {{static_cast<Number>(x), static_cast<Number>(y), static_cast<Number>(0.0)}}));
  }
  /// A square of cells of the height field around the camera's middle, in the rows that are left.
  static void add_heights(Writer& scene, Simulator& simulator) {
    constexpr double kSpacing = Model::kHeights.spacing;
    const Vector3 middle = followed(simulator);
    std::size_t side = 0;
    while ((side + 1) * (side + 1) + scene.rows() <= kSceneRows<Message>) ++side;
    const double half = 0.5 * static_cast<double>(side);
    const auto edge = [&](std::size_t axis, std::size_t i) {  // of the grid, in cells from 0
      return eagerx::floor(middle[axis] / kSpacing - half) + static_cast<double>(i);
    };
    const auto corner = [&](std::size_t i, std::size_t k) {
      const double x = kSpacing * edge(0, i), y = kSpacing * edge(1, k);
      return point({{x, y, height(simulator, x, y)}});
    };
    for (std::size_t i = 0; i < side; ++i) {
      for (std::size_t k = 0; k < side; ++k) {
        const double pairs = 0.5 * (edge(0, i) + edge(1, k));
        scene.facet({corner(i, k), corner(i + 1, k), corner(i + 1, k + 1), corner(i, k + 1)},
                    pairs == eagerx::floor(pairs) ? kGround : kDarkGround);
      }
    }
  }

  static void add_geometry(Writer& scene, Simulator& simulator, std::size_t g) {
    const RigidGeometry& shape = Model::kGeometries[g];
    const std::size_t body = body_of(shape.body);
    if (has_facets(body)) return;
    Vector3 at = shape.position;
    Quaternion turn = shape.rotation;
    if (body < kBodies) {
      const auto state = simulator.state(body);
      at = state.position + rotate(state.rotation, at);
      turn = product(state.rotation, turn);
    }
    const eagerx::Pose placed = pose(at, turn);
    const Point3 size = point(shape.size);
    switch (shape.kind) {
      case ShapeKind::sphere:
        return scene.sphere(placed.at, size.x, 0x3c4650);
      case ShapeKind::box:
        return scene.box(placed, size, colour(body));
      case ShapeKind::capsule:
        return scene.capsule(placed, size.x, size.y, colour(body));
      case ShapeKind::cylinder:
        return scene.cylinder(placed, size.x, size.y, colour(body));
      case ShapeKind::plane:
        return;
    }
  }

  /// Where the rod of joint j's child ends in the reference pose: at the next joint, else at a
  /// ball, else as far beyond the center of mass as the hinge is before it.
  static constexpr Vector3 rod_end(std::size_t j) {
    const Vector3& begin = Model::kJoints[j].anchor;
    const std::size_t body = body_of(Model::kJoints[j].child);
    const auto is_apart = [&](const Vector3& end) { return dot(end - begin, end - begin) > 1e-8; };
    for (const auto& next : Model::kJoints) {
      if (body_of(next.parent) == body && is_apart(next.anchor)) return next.anchor;
    }
    const Vector3& middle = Model::kBodies[body].position;
    for (const auto& shape : Model::kGeometries) {
      const Vector3 end = middle + shape.position;
      if (shape.kind == ShapeKind::sphere && body_of(shape.body) == body && is_apart(end))
        return end;
    }
    return 2.0 * middle - begin;
  }
  static void add_link(Writer& scene, Simulator& simulator, std::size_t j) {
    const RigidJoint& joint = Model::kJoints[j];
    const std::size_t child = body_of(joint.child);
    if (!is_rod_[child] || has_facets(child)) return;
    const auto state = simulator.state(child);
    const Vector3 end = rod_end(j), middle = 0.5 * (joint.anchor + end);
    const Vector3 at =
        state.position + rotate(state.rotation, middle - Model::kBodies[child].position);
    const Vector3 arm = rotate(state.rotation, end - joint.anchor);
    const double length = eagerx::sqrt(dot(arm, arm));
    const Vector3 d = 1.0 / length * arm;
    // From z to the direction of the arm, the short way.
    const Quaternion turn = d[2] < -0.999999 ? Quaternion{{0.0, 1.0, 0.0, 0.0}}
                                             : normalised({{1.0 + d[2], -d[1], d[0], 0.0}});
    scene.capsule(pose(at, turn), static_cast<float>(kThickness), static_cast<float>(length),
                  colour(child));
  }

  static constexpr Vector3 origin() {
    if constexpr (requires { Model::kOrigin; }) return Model::kOrigin;
    return {};
  }
  static void add_facets(Writer& scene, Simulator& simulator) {
    std::array<RigidState, kBodies> states;
    for (std::size_t b = 0; b < kBodies; ++b) {
      if (has_facets(b)) states[b] = simulator.state(b);
    }
    for (std::size_t f = 0; f < kFacetBody.size(); ++f) {
      const std::size_t body = kFacetBody[f];
      Point3 corners[4];
      for (std::size_t i = 0; i < 4; ++i) {
        const auto& corner = Model::kFacets[f].corners[i];
        const Vector3 from{{static_cast<double>(corner[0]), static_cast<double>(corner[1]),
                            static_cast<double>(corner[2])}};
        corners[i] =
            point(body < kBodies ? states[body].position + rotate(states[body].rotation, from)
                                 : origin() + from);
      }
      scene.facet(corners, colour(body));
    }
  }

  /// A homogeneous box of the same mass and inertia.
  static void add_box(Writer& scene, Simulator& simulator, std::size_t b) {
    const RigidBody& body = Model::kBodies[b];
    const Vector3& i = body.inertia;
    const auto side = [&](double one, double other, double own) {
      return static_cast<float>(
          eagerx::sqrt(eagerx::max(6.0 * (one + other - own) / body.mass, 1e-6)));
    };
    const auto state = simulator.state(b);
    scene.box(pose(state.position, state.rotation),
              {side(i[1], i[2], i[0]), side(i[0], i[2], i[1]), side(i[0], i[1], i[2])}, colour(b));
  }
};

}  // namespace eagerx::models
