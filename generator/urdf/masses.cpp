#include "generator/urdf/masses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "generator/urdf/inertia.hpp"

namespace eagerx::urdf {
namespace {

bool is_finite(const Vector3& v) {
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

}  // namespace

void give_masses(std::vector<Body>& bodies, gen::Diagnostics& diagnostics) {
  const double share = Link{}.share;
  double total = 0.0;
  for (const Body& body : bodies) total += body.mass;
  std::string names;
  std::size_t count = 0;
  gen::Span place;
  for (Body& body : bodies) {
    if (body.mass > 0.0) continue;
    if (!(total > 0.0)) {
      diagnostics.error("E0856", body.place, "nothing of the robot that can move has a mass").help =
          "give links an `inertial`";
      return;
    }
    body.mass = body.share * total;
    const double moment = std::max(ball_of_water(body.mass), body.mass * 0.05 * 0.05);
    body.inertia = {{moment, moment, moment}};
    body.products = {};
    if (body.share != share) continue;
    if (count++ == 0) place = body.place;
    names += fmt::format("{}`{}`", names.empty() ? "" : ", ", body.name);
  }
  if (count == 0) return;
  diagnostics
      .warning("E0856", place,
               fmt::format("can move, but {} no mass: {}; {} {:.3g} kg, 1/1000 of the robot's mass",
                           count == 1 ? "has" : "have", names, count == 1 ? "it gets" : "each gets",
                           share * total))
      .help = "give the link an `inertial`, or make its joint `fixed`";
}

void check_inertia(Body& body, gen::Diagnostics& diagnostics) {
  if (!(body.mass > 0.0)) return;
  if (!std::isfinite(body.mass)) return;  // check_finite() says so
  if (!is_positive(body.inertia, body.products)) {
    const double moment = ball_of_water(body.mass);
    body.inertia = {{moment, moment, moment}};
    body.products = {};
    diagnostics
        .warning("E0856", body.place,
                 fmt::format(
                     "no body has the inertia of `{}`: it is not positive definite; it gets that "
                     "of a ball of water of its mass, {:.3g} kg·m²",
                     body.name, moment))
        .help = "its principal moments are larger than 0; check the signs of ixy, ixz, iyz";
  } else if (!is_of_a_body(body.inertia, body.products)) {
    diagnostics.warning("E0856", body.place,
                        fmt::format("no body has the inertia of `{}`: one moment is larger than "
                                    "both others; it is used as it is",
                                    body.name));
  }
}

void check_finite(const Robot& robot, gen::Span place, gen::Diagnostics& diagnostics) {
  const auto refuse = [&](const gen::Span& at, const char* what, const std::string& name) {
    diagnostics.error("E0853", at, fmt::format("a number of the {} `{}` is too large", what, name));
  };
  for (const Body& body : robot.bodies) {
    if (!std::isfinite(body.mass) || !is_finite(body.inertia) || !is_finite(body.products) ||
        !is_finite(body.position))
      refuse(body.place, "body", body.name);
  }
  for (const BodyJoint& joint : robot.joints) {
    if (!is_finite(joint.anchor) || !is_finite(joint.axis))
      refuse(joint.limits.place, "joint", joint.name);
  }
  for (const Shape& shape : robot.shapes) {
    if (!is_finite(shape.size) || !is_finite(shape.position)) refuse(place, "shape", shape.name);
  }
}

}  // namespace eagerx::urdf
