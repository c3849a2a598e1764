#include "generator/urdf/mjcf_geoms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

namespace eagerx::urdf {
namespace {

using models::ShapeKind;

std::optional<ShapeKind> kind_of(const std::string& type) {
  static const std::map<std::string, ShapeKind> kKinds = {
      {"sphere", ShapeKind::sphere},     {"capsule", ShapeKind::capsule},
      {"box", ShapeKind::box},           {"cylinder", ShapeKind::cylinder},
      {"ellipsoid", ShapeKind::capsule}, {"plane", ShapeKind::plane},
      {"mesh", ShapeKind::box}};
  const auto known = kKinds.find(type);
  return known != kKinds.end() ? std::optional(known->second) : std::nullopt;
}

/// How many numbers of `size` a geom needs.
std::size_t numbers_of(const std::string& type, bool has_ends) {
  if (type == "sphere" || has_ends) return 1;
  if (type == "plane" || type == "mesh") return 0;
  return type == "box" || type == "ellipsoid" ? 3 : 2;
}

std::string stem_of(const std::string& file) {
  return std::filesystem::path(file).stem().string();
}

}  // namespace

unsigned bits_of(const Element& element, const char* attribute) {
  constexpr double kLeast = std::numeric_limits<int>::min(),
                   kMost = std::numeric_limits<int>::max();
  return static_cast<unsigned>(
      static_cast<int>(std::clamp(element.number(attribute, 1.0), kLeast, kMost)));
}

void Geoms::read_meshes() {
  for (const pugi::xml_node one : document_.section("asset")) {
    if (std::string_view(one.name()) != "mesh") continue;
    const Element element(document_, one, document_.main_class());
    MeshAsset asset;
    const std::string file = element.text("file");
    asset.mesh.file =
        compiler_.mesh_folder +
        (compiler_.strips_paths ? std::filesystem::path(file).filename().string() : file);
    if (std::filesystem::path(file).is_absolute()) asset.mesh.file = file;
    asset.mesh.place = element.span("file");
    asset.mesh.scale = element.vector("scale", {{1.0, 1.0, 1.0}});
    Frame moved;
    moved.position = element.vector("refpos", {});
    if (const auto q = element.numbers("refquat", 4); q.size() == 4)
      moved.rotation = models::normalised({{q[0], q[1], q[2], q[3]}});
    const Quaternion back = models::inverse(moved.rotation);
    for (std::size_t i = 0; i < 3; ++i) moved.position[i] *= asset.mesh.scale[i];
    asset.origin = {-1.0 * rotate(back, moved.position), back};
    const std::string name = element.text("name").empty() ? stem_of(file) : element.text("name");
    if (file.empty()) {
      element.error("E0851", element.span(), "meshes without a `file` are not supported").help =
          "write the vertices to a file of OBJ";
      continue;
    }
    meshes_.emplace(name, asset);
  }
}

Geom Geoms::read(const Element& element, const Frame& in, bool has_mass) {
  Geom result;
  const std::string written = element.text("type");
  const std::string type = element.has("mesh") ? "mesh" : written.empty() ? "sphere" : written;
  result.type = bits_of(element, "contype");
  result.affinity = bits_of(element, "conaffinity");
  const auto kind = kind_of(type);
  if (type == "hfield") {
    element
        .warning("E0851", element.span("type"),
                 "fields of heights are left out: the ground is a plane")
        .help = "`kHeights` of an object's model has heights";
    return result;
  }
  if (!kind) {
    element
        .error("E0851", element.span("type"),
               fmt::format("geoms of type `{}` are not supported", type))
        .help = gen::did_you_mean(
        type, {"sphere", "capsule", "box", "cylinder", "ellipsoid", "plane", "mesh"},
        "use a `sphere`, `capsule`, `box`, `cylinder`, `ellipsoid`, `plane` or `mesh`");
    return result;
  }
  Collision shape;
  shape.name = element.text("name");
  shape.place = element.span();
  shape.kind = *kind;
  if (const auto friction = element.numbers("friction", 3); !friction.empty())
    shape.friction = friction[0];
  Frame frame = frame_of(element, compiler_);
  if (type == "mesh") {
    if (!set_mesh(element, shape, frame)) return result;
  } else {
    set_size(element, shape, frame, type);
  }
  shape.origin = in * frame;
  result.shape = shape;
  if (has_mass) result.inertial = mass_of(element, shape, type);
  return result;
}

void Geoms::set_size(const Element& element, Collision& shape, Frame& frame,
                     const std::string& type) {
  const auto ends = element.numbers("fromto", 6);
  if (!ends.empty() && ends.size() != 6)
    element.error("E0853", element.span("fromto"), "`fromto` has to be six numbers");
  const bool has_ends = ends.size() == 6 && type != "sphere" && type != "plane";
  std::vector<double> size = element.numbers("size", 3);
  const std::size_t needed = numbers_of(type, has_ends);
  if (size.size() < needed) {
    if (!size.empty() || element.text("size").empty())
      element.error(size.empty() ? "E0852" : "E0853", element.span("size"),
                    fmt::format("a `{}` needs {} of `size`", type,
                                needed == 1 ? "1 number" : fmt::format("{} numbers", needed)));
    size.assign(3, 1.0);
  }
  size.resize(3, 0.0);
  for (std::size_t i = 0; i < needed; ++i) {
    if (!(size[i] > 0.0))
      element.error("E0853", element.span("size"), "`size` has to be larger than 0");
  }
  double half = size[1];
  if (has_ends) {
    const Vector3 from{{ends[0], ends[1], ends[2]}}, to{{ends[3], ends[4], ends[5]}};
    const Vector3 along = from - to;
    half = 0.5 * std::sqrt(dot(along, along));
    frame = {0.5 * (from + to), rotation_to(along)};
    size[1] = size[0];
    size[2] = half;
  }
  if (type == "sphere") shape.size[0] = size[0];
  if (type == "capsule" || type == "cylinder") shape.size = {{size[0], 2.0 * half, 0.0}};
  if (type == "box") shape.size = {{2.0 * size[0], 2.0 * size[1], 2.0 * size[2]}};
  if (type == "plane") shape.normal = {{0.0, 0.0, 1.0}};
  if (type == "ellipsoid") set_ellipsoid({{size[0], size[1], size[2]}}, shape, frame);
}

/// The smallest capsule around it: as thick as its second axis, and as long as the first.
void Geoms::set_ellipsoid(const Vector3& half, Collision& shape, Frame& frame) {
  std::size_t longest = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (half[i] > half[longest]) longest = i;
  }
  const double second = std::max(half[(longest + 1) % 3], half[(longest + 2) % 3]);
  const double length = 2.0 * (half[longest] - second);
  shape.kind = length > 0.0 ? ShapeKind::capsule : ShapeKind::sphere;
  shape.size = {{second, length, 0.0}};
  ellipsoid_ = solid_ellipsoid(half);
  if (!(length > 0.0)) return;
  Vector3 axis{};
  axis[longest] = 1.0;
  const Quaternion turn = rotation_to(axis);
  ellipsoid_.origin.rotation = models::inverse(turn);  // it keeps its own axes
  frame = frame * Frame{{}, turn};
}

bool Geoms::set_mesh(const Element& element, Collision& shape, Frame& frame) {
  const std::string name = element.text("mesh");
  const auto known = meshes_.find(name);
  if (known == meshes_.end()) {
    std::vector<std::string> names;
    for (const auto& [one, asset] : meshes_) names.push_back(one);
    element.error("E0854", element.span("mesh"), fmt::format("there is no mesh `{}`", name)).help =
        gen::did_you_mean(name, names);
    return false;
  }
  shape.mesh = known->second.mesh;
  frame = frame * known->second.origin;
  return true;
}

std::optional<Inertial> Geoms::mass_of(const Element& element, const Collision& shape,
                                       const std::string& type) {
  const double group = element.number("group", 0.0);
  if (type == "plane" || group < compiler_.first_group || group > compiler_.last_group)
    return std::nullopt;
  if (element.flag("shellinertia").value_or(false))
    element.warning("E0851", element.span("shellinertia"), "its inertia is that of a solid body");
  const double mass = element.not_negative("mass", -0.0);
  if (element.has("mass") && mass == 0.0) return std::nullopt;
  Inertial result = type == "mesh"        ? solid(*shape.mesh)
                    : type == "ellipsoid" ? ellipsoid_
                                          : solid_shape(shape.kind, shape.size);
  if (!(result.mass > 0.0)) return std::nullopt;
  const double factor =
      element.has("mass") ? mass / result.mass : element.not_negative("density", 1000.0);
  result.mass *= factor;
  result.inertia = factor * result.inertia;
  result.products = factor * result.products;
  result.origin = shape.origin * result.origin;
  return result;
}

}  // namespace eagerx::urdf
