#include "generator/urdf/mjcf_frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace eagerx::urdf {
namespace {

constexpr Vector3 kX{{1.0, 0.0, 0.0}}, kY{{0.0, 1.0, 0.0}}, kZ{{0.0, 0.0, 1.0}};

Vector3 unit(const Vector3& v) {
  const double square = dot(v, v);
  return square > 1e-24 ? (1.0 / std::sqrt(square)) * v : kZ;
}

/// The rotation whose columns these unit vectors are.
Quaternion rotation_of_columns(const Vector3& x, const Vector3& y, const Vector3& z) {
  // The largest part first, so that nothing is divided by what is near 0.
  const double w = 1.0 + x[0] + y[1] + z[2], a = 1.0 + x[0] - y[1] - z[2],
               b = 1.0 - x[0] + y[1] - z[2], c = 1.0 - x[0] - y[1] + z[2];
  Quaternion q{};
  if (w >= a && w >= b && w >= c) {
    q = {{w, y[2] - z[1], z[0] - x[2], x[1] - y[0]}};
  } else if (a >= b && a >= c) {
    q = {{y[2] - z[1], a, x[1] + y[0], z[0] + x[2]}};
  } else if (b >= c) {
    q = {{z[0] - x[2], x[1] + y[0], b, y[2] + z[1]}};
  } else {
    q = {{x[1] - y[0], z[0] + x[2], y[2] + z[1], c}};
  }
  return models::normalised(q);
}

Quaternion of_euler(const std::vector<double>& angles, const Compiler& compiler) {
  Quaternion result = models::kNoRotation;
  for (std::size_t i = 0; i < 3; ++i) {
    const char axis = compiler.euler[i];
    const bool turns_along = axis >= 'x';
    const Vector3& about = axis == 'x' || axis == 'X' ? kX : axis == 'y' || axis == 'Y' ? kY : kZ;
    const Quaternion one = models::rotation(about, angles[i] * compiler.angle);
    result = turns_along ? product(result, one) : product(one, result);
  }
  return models::normalised(result);
}

Quaternion of_axes(const std::vector<double>& six) {
  const Vector3 x = unit({{six[0], six[1], six[2]}});
  const Vector3 written{{six[3], six[4], six[5]}};
  const Vector3 y = unit(written - dot(x, written) * x);
  return rotation_of_columns(x, y, models::cross(x, y));
}

/// Exactly as many numbers; empty after an error.
std::vector<double> list_of(const Element& element, const char* attribute, std::size_t count) {
  const auto list = element.numbers(attribute, count);
  if (list.size() == count) return list;
  if (!list.empty() || element.text(attribute).empty())
    element.error("E0853", element.span(attribute),
                  fmt::format("`{}` has to be {} numbers, not `{}`", attribute, count,
                              element.text(attribute)));
  return {};
}

void read_one(const Element& at, Compiler& to) {
  if (at.has("angle")) to.angle = at.text("angle") == "radian" ? 1.0 : std::numbers::pi / 180.0;
  if (const std::string euler = at.text("eulerseq"); !euler.empty()) {
    if (euler.size() == 3 && euler.find_first_not_of("xyzXYZ") == std::string::npos)
      to.euler = euler;
    else
      at.error("E0853", at.span("eulerseq"), "`eulerseq` is made of three of `x`, `y`, `z`");
  }
  to.autolimits = at.flag("autolimits").value_or(to.autolimits);
  for (const char* const name : {"assetdir", "meshdir"}) {
    if (const std::string folder = at.text(name); !folder.empty())
      to.mesh_folder = folder.ends_with('/') ? folder : folder + '/';
  }
  to.strips_paths = at.flag("strippath").value_or(to.strips_paths);
  if (at.has("inertiafromgeom")) to.inertia_from_geoms = at.flag("inertiafromgeom");
  if (const auto range = at.numbers("inertiagrouprange", 2); range.size() == 2) {
    to.first_group = range[0];
    to.last_group = range[1];
  }
  to.least_mass = at.not_negative("boundmass", to.least_mass);
  to.least_inertia = at.not_negative("boundinertia", to.least_inertia);
  to.balances_inertia = at.flag("balanceinertia").value_or(to.balances_inertia);
  to.total_mass = at.number("settotalmass", to.total_mass);
  if (at.text("coordinate") == "global")
    at.error("E0851", at.span("coordinate"), "`coordinate` `global` is not supported").help =
        "MuJoCo 2.3.3 and later do not read it either: save the model with an earlier one";
}

}  // namespace

Compiler read_compiler(Document& document) {
  Compiler result;
  for (const pugi::xml_node one : document.sections()) {
    if (std::string_view(one.name()) != "compiler") continue;
    document.xml(one).check(one,
                            {.attributes = {"angle",        "eulerseq",         "autolimits",
                                            "meshdir",      "assetdir",         "texturedir",
                                            "strippath",    "inertiafromgeom",  "inertiagrouprange",
                                            "boundmass",    "boundinertia",     "balanceinertia",
                                            "settotalmass", "coordinate",       "fitaabb",
                                            "usethread",    "discardvisual",    "convexhull",
                                            "fusestatic",   "exactmeshinertia", "alignfree",
                                            "saveinertial"},
                             .many = {"lengthrange"}});
    read_one(Element(document, one, nullptr), result);
  }
  return result;
}

Frame frame_of(const Element& element, const Compiler& compiler) {
  Frame result;
  result.position = element.vector("pos", {});
  if (element.has("quat")) {
    if (const auto q = list_of(element, "quat", 4); !q.empty())
      result.rotation = models::normalised({{q[0], q[1], q[2], q[3]}});
  } else if (element.has("axisangle")) {
    if (const auto a = list_of(element, "axisangle", 4); !a.empty())
      result.rotation = models::rotation(unit({{a[0], a[1], a[2]}}), a[3] * compiler.angle);
  } else if (element.has("euler")) {
    if (const auto angles = list_of(element, "euler", 3); !angles.empty())
      result.rotation = of_euler(angles, compiler);
  } else if (element.has("xyaxes")) {
    if (const auto axes = list_of(element, "xyaxes", 6); !axes.empty())
      result.rotation = of_axes(axes);
  } else if (element.has("zaxis")) {
    result.rotation = rotation_to(element.direction("zaxis", kZ));
  }
  return result;
}

Quaternion rotation_to(const Vector3& direction) {
  const Vector3 to = unit(direction), axis = models::cross(kZ, to);
  const double sine = std::sqrt(dot(axis, axis));
  if (sine < 1e-12)
    return to[2] > 0.0 ? models::kNoRotation : models::rotation(kX, std::numbers::pi);
  return models::rotation((1.0 / sine) * axis, std::atan2(sine, to[2]));
}

}  // namespace eagerx::urdf
