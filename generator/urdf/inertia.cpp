#include "generator/urdf/inertia.hpp"

#include <cmath>
#include <numbers>

namespace eagerx::urdf {
namespace {

Vector3 times(const Vector3& inertia, const Vector3& products, const Vector3& v) {
  return {{inertia[0] * v[0] + products[0] * v[1] + products[1] * v[2],
           products[0] * v[0] + inertia[1] * v[1] + products[2] * v[2],
           products[1] * v[0] + products[2] * v[1] + inertia[2] * v[2]}};
}

}  // namespace

MassAndInertia turned(const Inertial& inertial, const Frame& link) {
  MassAndInertia result;
  result.mass = inertial.mass;
  result.centre = link.position + rotate(link.rotation, inertial.origin.position);
  const Quaternion turn = models::normalised(product(link.rotation, inertial.origin.rotation));
  Vector3 columns[3];
  for (std::size_t i = 0; i < 3; ++i) {
    Vector3 axis{};
    axis[i] = 1.0;
    columns[i] = rotate(
        turn, times(inertial.inertia, inertial.products, rotate(models::inverse(turn), axis)));
  }
  result.inertia = {{columns[0][0], columns[1][1], columns[2][2]}};
  result.products = {{columns[1][0], columns[2][0], columns[2][1]}};
  return result;
}

MassAndInertia together(const std::vector<MassAndInertia>& parts) {
  if (parts.size() == 1) return parts[0];  // without rounding
  MassAndInertia all;
  for (const MassAndInertia& part : parts) {
    all.mass += part.mass;
    all.centre = all.centre + part.mass * part.centre;
  }
  if (!(all.mass > 0.0)) return all;
  all.centre = (1.0 / all.mass) * all.centre;
  for (const MassAndInertia& part : parts) {
    const Vector3 d = part.centre - all.centre;
    const double square = dot(d, d);
    for (std::size_t i = 0; i < 3; ++i)
      all.inertia[i] += part.inertia[i] + part.mass * (square - d[i] * d[i]);
    all.products[0] += part.products[0] - part.mass * d[0] * d[1];
    all.products[1] += part.products[1] - part.mass * d[0] * d[2];
    all.products[2] += part.products[2] - part.mass * d[1] * d[2];
  }
  return all;
}

double ball_of_water(double mass) {
  const double radius = std::cbrt(0.75 * mass / (std::numbers::pi * 1000.0));
  return 0.4 * mass * radius * radius;
}

bool is_positive(const Vector3& inertia, const Vector3& products) {
  // Sylvester: the leading minors are positive.
  const double xy = products[0], xz = products[1], yz = products[2];
  const double second = inertia[0] * inertia[1] - xy * xy;
  const double third =
      inertia[2] * second - inertia[0] * yz * yz + xz * (2.0 * xy * yz - inertia[1] * xz);
  return inertia[0] > 0.0 && second > 0.0 && third > 0.0;
}

bool is_of_a_body(const Vector3& inertia, const Vector3& products) {
  // The same of trace/2 minus the inertia, the second moments of the mass.
  constexpr double kRounding = 1e-6;
  const double half = 0.5 * (1.0 + kRounding) * (inertia[0] + inertia[1] + inertia[2]);
  return is_positive({{half - inertia[0], half - inertia[1], half - inertia[2]}}, -1.0 * products);
}

}  // namespace eagerx::urdf
