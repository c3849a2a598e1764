// Masses and inertia of shapes that are filled evenly.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "generator/urdf/meshes.hpp"
#include "generator/urdf/mjcf_geoms.hpp"

namespace eagerx::urdf {
namespace {

Inertial with(double mass, const Vector3& inertia_of_one_kilogram) {
  Inertial result;
  result.mass = mass;
  result.inertia = mass * inertia_of_one_kilogram;
  return result;
}

/// A cylinder with half spheres at its ends.
Inertial solid_capsule(double radius, double length) {
  const double square = radius * radius;
  const double middle = std::numbers::pi * square * length,
               ends = 4.0 / 3.0 * std::numbers::pi * square * radius;
  const double about_z = middle * square / 2.0 + ends * 0.4 * square;
  const double across = middle * (3.0 * square + length * length) / 12.0 +
                        ends * (0.4 * square + length * (3.0 * radius + 2.0 * length) / 8.0);
  Inertial result;
  result.mass = middle + ends;
  result.inertia = {{across, across, about_z}};
  return result;
}

/// Sums of integrals over the tetrahedra of triangles and the origin.
struct Moments {
  double volume = 0.0;
  Vector3 first{};     // of x, y, z
  Vector3 squares{};   // of x², y², z²
  Vector3 products{};  // of xy, xz, yz

  void add(const Vector3& a, const Vector3& b, const Vector3& c) {
    const double six = dot(a, models::cross(b, c));
    const Vector3 sum = a + b + c;
    volume += six / 6.0;
    first = first + (six / 24.0) * sum;
    const auto integral = [&](std::size_t i, std::size_t k) {
      return six / 120.0 * (a[i] * a[k] + b[i] * b[k] + c[i] * c[k] + sum[i] * sum[k]);
    };
    squares = squares + Vector3{{integral(0, 0), integral(1, 1), integral(2, 2)}};
    products = products + Vector3{{integral(0, 1), integral(0, 2), integral(1, 2)}};
  }
};

Inertial solid_of(const Moments& m) {
  Inertial result;
  if (std::abs(m.volume) < 1e-18) return result;
  const double sign = m.volume < 0.0 ? -1.0 : 1.0;  // triangles may look inwards
  const Vector3 c = (1.0 / m.volume) * m.first;
  const Vector3 s =
      sign * (m.squares - m.volume * Vector3{{c[0] * c[0], c[1] * c[1], c[2] * c[2]}});
  result.mass = sign * m.volume;
  result.origin.position = c;
  result.inertia = {{s[1] + s[2], s[0] + s[2], s[0] + s[1]}};
  result.products =
      -sign * (m.products - m.volume * Vector3{{c[0] * c[1], c[0] * c[2], c[1] * c[2]}});
  return result;
}

}  // namespace

Inertial solid_ellipsoid(const Vector3& half) {
  const double x = half[0] * half[0], y = half[1] * half[1], z = half[2] * half[2];
  return with(4.0 / 3.0 * std::numbers::pi * half[0] * half[1] * half[2],
              0.2 * Vector3{{y + z, x + z, x + y}});
}

Inertial solid_shape(models::ShapeKind kind, const Vector3& size) {
  const double square = size[0] * size[0];
  if (kind == models::ShapeKind::sphere)
    return with(4.0 / 3.0 * std::numbers::pi * square * size[0],
                0.4 * square * Vector3{{1.0, 1.0, 1.0}});
  if (kind == models::ShapeKind::capsule) return solid_capsule(size[0], size[1]);
  if (kind == models::ShapeKind::cylinder) {
    const double across = (3.0 * square + size[1] * size[1]) / 12.0;
    return with(std::numbers::pi * square * size[1], {{across, across, square / 2.0}});
  }
  if (kind == models::ShapeKind::box) {
    const double x = square, y = size[1] * size[1], z = size[2] * size[2];
    return with(size[0] * size[1] * size[2], 1.0 / 12.0 * Vector3{{y + z, x + z, x + y}});
  }
  return {};
}

const Inertial& Geoms::solid(const Mesh& mesh) {
  const Vector3& scale = mesh.scale;
  const auto [at, is_new] =
      solids_.try_emplace(fmt::format("{} {} {} {}", mesh.file, scale[0], scale[1], scale[2]));
  if (!is_new) return at->second;
  const std::string path = find_mesh(mesh.file, document_.folder(), {});
  const LoadedMesh loaded = path.empty() ? LoadedMesh{} : load_mesh(path);
  if (loaded.triangles.empty()) {
    Xml& main = document_.xml(document_.root());
    main.warning("E0858", mesh.place,
                 fmt::format("cannot read `{}`{}: its body lacks the mass of it", mesh.file,
                             loaded.problem.empty() ? "" : " (" + loaded.problem + ")"));
  }
  Moments moments;
  const auto scaled = [&](const Vector3& p) {
    return Vector3{{p[0] * scale[0], p[1] * scale[1], p[2] * scale[2]}};
  };
  for (std::size_t i = 0; i + 2 < loaded.triangles.size(); i += 3)
    moments.add(scaled(loaded.triangles[i]), scaled(loaded.triangles[i + 1]),
                scaled(loaded.triangles[i + 2]));
  return at->second = solid_of(moments);
}

}  // namespace eagerx::urdf
