#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>

#include "generator/frontend/read/scalar.hpp"
#include "generator/frontend/read/text.hpp"
#include "generator/support/files/missing_file.hpp"
#include "generator/urdf/mjcf.hpp"
#include "generator/urdf/urdf.hpp"
#include "generator/urdf/xml.hpp"

namespace eagerx::urdf {
namespace {

constexpr std::size_t kMaxBytes = 4'000'000;
constexpr std::size_t kMaxItems = 1'000;  // links, and joints; the simulation would not end

/// First about x, then about the fixed y, then about the fixed z [rad].
Quaternion rotation_of(const Vector3& rpy) {
  using models::rotation;
  const Quaternion roll = rotation({{1.0, 0.0, 0.0}}, rpy[0]);
  const Quaternion pitch = rotation({{0.0, 1.0, 0.0}}, rpy[1]);
  const Quaternion yaw = rotation({{0.0, 0.0, 1.0}}, rpy[2]);
  return models::normalised(product(yaw, product(pitch, roll)));
}

/// Macros that have not been expanded: what xacro makes keeps the declaration of the prefix, and
/// comments.
bool is_xacro(std::string_view path, std::string_view text) {
  if (path.ends_with(".xacro")) return true;
  for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at + 1)) {
    if (text.substr(at).starts_with("<xacro:")) return true;
    if (text.substr(at).starts_with("<!--")) at = text.find("-->", at);
    if (at == std::string_view::npos) break;
  }
  return false;
}

/// A robot without a name is called like its file.
std::string name_without(const std::string& path) {
  const std::string stem = std::filesystem::path(path).stem().string();
  return stem.substr(0, stem.find('.'));
}

class Reader {
 public:
  explicit Reader(Xml& xml) : xml_(xml) {}

  Description read(pugi::xml_node robot) {
    Description result;
    xml_.check(
        robot,
        {.attributes = {"name", "version"}, .many = {"link", "joint"}, .unseen = {"material"}});
    result.name = robot.attribute("name").value();
    result.place = xml_.span(robot);
    for (const pugi::xml_node element : robot.children("link")) {
      result.links.push_back(link(element));
      if (result.links.size() > kMaxItems) break;
    }
    for (const pugi::xml_node element : robot.children("joint")) {
      result.joints.push_back(joint(element));
      if (result.joints.size() > kMaxItems) break;
    }
    if (result.links.size() > kMaxItems || result.joints.size() > kMaxItems)
      xml_.error("E0851", result.place,
                 fmt::format("there are more than {} links or joints", kMaxItems));
    xml_.report_left_out();
    return result;
  }

 private:
  Frame origin(pugi::xml_node element) {
    const pugi::xml_node origin = element.child("origin");
    if (!origin) return {};
    xml_.check(origin, {.attributes = {"xyz", "rpy"}});
    return {xml_.vector(origin, "xyz", Vector3{}),
            rotation_of(xml_.vector(origin, "rpy", Vector3{}))};
  }

  Link link(pugi::xml_node element) {
    xml_.check(element, {.attributes = {"name", "type"},
                         .once = {"inertial"},
                         .many = {"collision"},
                         .unseen = {"visual"}});
    Link result;
    result.name = xml_.text(element, "name");
    result.place = xml_.span(element, "name");
    if (const pugi::xml_node inertial = element.child("inertial")) {
      result.inertial = this->inertial(inertial);
      result.inertial_place = xml_.span(inertial);
    }
    for (const pugi::xml_node collision : element.children("collision"))
      result.collisions.push_back(this->collision(collision));
    for (const pugi::xml_node visual : element.children("visual")) {
      if (const pugi::xml_node file = visual.child("geometry").child("mesh")) {
        const pugi::xml_node origin = visual.child("origin");
        result.visuals.push_back({{file.attribute("filename").value(), xml_.span(file, "filename"),
                                   seen(file, "scale", {{1.0, 1.0, 1.0}})},
                                  {seen(origin, "xyz", {}), rotation_of(seen(origin, "rpy", {}))}});
      }
    }
    return result;
  }
  /// Three numbers of what is only drawn: any problem leaves `otherwise`.
  static Vector3 seen(pugi::xml_node element, const char* name, const Vector3& otherwise) {
    std::string_view text = element.attribute(name).value();
    Vector3 result{};
    for (std::size_t i = 0; i < 3; ++i) {
      text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
      const std::size_t size = std::min(text.find_first_of(" \t\r\n"), text.size());
      const auto value = gen::parse_number(text.substr(0, size));
      if (!value || !std::isfinite(*value)) return otherwise;
      result[i] = *value;
      text.remove_prefix(size);
    }
    return result;
  }

  Inertial inertial(pugi::xml_node element) {
    xml_.check(element, {.once = {"origin", "mass", "inertia"}});
    Inertial result;
    result.origin = origin(element);
    const pugi::xml_node mass = xml_.child(element, "mass");
    xml_.check(mass, {.attributes = {"value"}});
    result.mass = xml_.number(mass, "value");
    if (result.mass < 0.0) xml_.error("E0853", xml_.span(mass), "a mass cannot be negative");
    const pugi::xml_node inertia = xml_.child(element, "inertia");
    xml_.check(inertia, {.attributes = {"ixx", "ixy", "ixz", "iyy", "iyz", "izz"}});
    result.inertia = {
        {xml_.number(inertia, "ixx"), xml_.number(inertia, "iyy"), xml_.number(inertia, "izz")}};
    result.products = {{xml_.number(inertia, "ixy", 0.0), xml_.number(inertia, "ixz", 0.0),
                        xml_.number(inertia, "iyz", 0.0)}};
    return result;
  }

  Collision collision(pugi::xml_node element) {
    xml_.check(element,
               {.attributes = {"name"}, .once = {"origin", "geometry"}, .unseen = {"material"}});
    Collision result;
    result.name = element.attribute("name").value();
    result.place = xml_.span(element);
    result.origin = origin(element);
    const pugi::xml_node geometry = xml_.child(element, "geometry");
    if (!geometry) return result;
    const auto is_element = [](pugi::xml_node node) {
      return node.type() == pugi::node_element && std::string_view(node.name()) != "material";
    };
    const pugi::xml_node shape = geometry.find_child(is_element);
    if (!shape) xml_.error("E0852", xml_.span(geometry), "`geometry` has no shape");
    for (pugi::xml_node other = shape.next_sibling(); other; other = other.next_sibling()) {
      if (is_element(other))
        xml_.error("E0851", xml_.span(other), "`geometry` has a second shape").help =
            "give the link another `collision`";
    }
    set_shape(shape, result);
    return result;
  }

  void set_shape(pugi::xml_node shape, Collision& result) {
    const std::string_view kind = shape.name();
    if (kind == "box") {
      result.kind = models::ShapeKind::box;
      xml_.check(shape, {.attributes = {"size"}});
      result.size = xml_.vector(shape, "size");
      if (result.size[0] <= 0.0 || result.size[1] <= 0.0 || result.size[2] <= 0.0)
        xml_.error("E0853", xml_.span(shape, "size"), "the sides of a box are larger than 0");
    } else if (kind == "sphere") {
      result.kind = models::ShapeKind::sphere;
      xml_.check(shape, {.attributes = {"radius"}});
      result.size[0] = xml_.positive(shape, "radius");
    } else if (kind == "cylinder" || kind == "capsule") {
      result.kind = kind == "cylinder" ? models::ShapeKind::cylinder : models::ShapeKind::capsule;
      xml_.check(shape, {.attributes = {"radius", "length"}});
      result.size = {{xml_.positive(shape, "radius"), xml_.positive(shape, "length"), 0.0}};
    } else if (kind == "plane") {  // of Bullet
      result.kind = models::ShapeKind::plane;
      xml_.check(shape, {.attributes = {"normal"}});
      result.normal = xml_.direction(shape, "normal");
    } else if (kind == "mesh") {
      result.mesh = mesh(shape);
    } else if (shape) {
      xml_.error("E0851", xml_.span(shape),
                 fmt::format("shapes of kind `{}` are not supported", kind))
          .help = gen::did_you_mean(kind, {"box", "sphere", "cylinder", "capsule", "mesh"},
                                    "use a `box`, `sphere`, `cylinder`, `capsule` or `mesh`");
    }
  }

  Mesh mesh(pugi::xml_node element) {
    xml_.check(element, {.attributes = {"filename", "scale"}});
    Mesh result;
    result.file = xml_.text(element, "filename");
    result.place = xml_.span(element, "filename");
    result.scale = xml_.scale(element, "scale");
    return result;
  }

  Joint joint(pugi::xml_node element) {
    xml_.check(element, {.attributes = {"name", "type", "dont_collapse"},
                         .once = {"origin", "parent", "child", "axis", "limit", "dynamics",
                                  "joint_properties", "mimic"}});
    Joint result;
    result.name = xml_.text(element, "name");
    result.place = xml_.span(element, "name");
    set_type(element, result);
    result.origin = origin(element);
    const auto end = [&](const char* name, std::string& link, gen::Span& place) {
      const pugi::xml_node which = xml_.child(element, name);
      xml_.check(which, {.attributes = {"link"}});
      link = xml_.text(which, "link");
      place = which ? xml_.span(which, "link") : result.place;
    };
    end("parent", result.parent, result.parent_place);
    end("child", result.child, result.child_place);
    if (result.type == JointType::fixed || result.type == JointType::floating) return result;
    set_axis(element.child("axis"), result);
    set_limits(element, result);
    for (const char* const name : {"dynamics", "joint_properties"}) {  // the second one until 2010
      const pugi::xml_node dynamics = element.child(name);
      if (!dynamics) continue;
      xml_.check(dynamics, {.attributes = {"damping", "friction"}});
      result.damping = xml_.not_negative(dynamics, "damping", 0.0);
      result.friction = xml_.not_negative(dynamics, "friction", 0.0);
    }
    if (const pugi::xml_node mimic = element.child("mimic")) {
      xml_.check(mimic, {.attributes = {"joint", "multiplier", "offset"}});
      result.mimic = {xml_.text(mimic, "joint"), xml_.span(mimic, "joint"),
                      xml_.number(mimic, "multiplier", 1.0), xml_.number(mimic, "offset", 0.0)};
    }
    return result;
  }

  void set_type(pugi::xml_node element, Joint& result) {
    static const std::map<std::string, JointType> kTypes = {
        {"fixed", JointType::fixed},           {"revolute", JointType::revolute},
        {"continuous", JointType::continuous}, {"prismatic", JointType::prismatic},
        {"planar", JointType::planar},         {"spherical", JointType::spherical},
        {"floating", JointType::floating}};
    const std::string type = xml_.text(element, "type");
    const auto known = kTypes.find(type);
    if (known != kTypes.end()) {
      result.type = known->second;
    } else if (!type.empty()) {
      auto& wrong = xml_.error("E0851", xml_.span(element, "type"),
                               fmt::format("joints of type `{}` are not supported", type));
      wrong.help = gen::did_you_mean(
          type, {"fixed", "revolute", "continuous", "prismatic", "planar", "floating"},
          "`fixed`, `revolute`, `continuous`, `prismatic`, `planar` and `floating` are");
    }
  }

  void set_axis(pugi::xml_node axis, Joint& result) {
    if (!axis) return;
    xml_.check(axis, {.attributes = {"xyz"}});
    result.axis = xml_.direction(axis, "xyz");
  }

  void set_limits(pugi::xml_node element, Joint& result) {
    const bool has_range =
        result.type == JointType::revolute || result.type == JointType::prismatic;
    const pugi::xml_node limit = element.child("limit");
    if (!limit) {
      if (has_range) xml_.warning("E0852", result.place, "`joint` has no `limit`: it has no stops");
      return;
    }
    xml_.check(limit, {.attributes = {"lower", "upper", "effort", "velocity"}});
    constexpr double kUnlimited = std::numeric_limits<double>::infinity();
    result.effort = xml_.not_negative(limit, "effort", kUnlimited);
    result.velocity = xml_.not_negative(limit, "velocity", kUnlimited);
    // Exporters write 0 where they know no limit.
    if (result.velocity == 0.0) {
      result.velocity = kUnlimited;
      if (result.effort == 0.0) result.effort = kUnlimited;
    }
    if (has_range) set_stops(limit, result);
  }

  void set_stops(pugi::xml_node limit, Joint& result) {
    constexpr double kNoStop = 1e3;  // rad or m: written for "none"
    const double lower = xml_.number(limit, "lower", 0.0), upper = xml_.number(limit, "upper", 0.0);
    if (lower > upper) {  // how Bullet writes it
      xml_.warning("E0853", xml_.span(limit, "lower"),
                   "`lower` is above `upper`: the joint has no stops");
      return;
    }
    if (lower > -kNoStop) result.lower = lower;
    if (upper < kNoStop) result.upper = upper;
  }

  Xml& xml_;
};

}  // namespace

std::optional<Description> read_text(const std::string& name, std::string text,
                                     gen::SourceMap& sources, gen::Diagnostics& diagnostics) {
  const gen::FileId file = sources.add(name, gen::normalize_text(std::move(text)));
  if (!gen::check_text(sources.text(file), file, diagnostics)) return std::nullopt;
  Xml xml(file, sources.text(file), diagnostics);
  pugi::xml_document document;
  const pugi::xml_node root = xml.parse(document, {"robot", "mujoco"});
  if (!root) return std::nullopt;
  const bool is_mjcf = std::string_view(root.name()) == "mujoco";
  Description result =
      is_mjcf ? read_mjcf(name, xml, root, sources, diagnostics) : Reader(xml).read(root);
  result.file = std::filesystem::path(name).filename().string();
  if (diagnostics.has_errors()) return std::nullopt;
  if (result.name.empty()) {
    result.name = name_without(name);
    if (!is_mjcf)
      diagnostics.warning("E0852", result.place,
                          fmt::format("`robot` has no `name`: it is called `{}`", result.name));
  }
  expand_joints(result);
  return result;
}

std::optional<Description> read_file(const std::string& path, gen::SourceMap& sources,
                                     gen::Diagnostics& diagnostics) {
  gen::LoadedFile file = gen::load_file(path, kMaxBytes);
  if (file.status == gen::LoadedFile::Status::loaded) {
    if (!is_xacro(path, file.bytes))
      return read_text(path, std::move(file.bytes), sources, diagnostics);
    const gen::Span whole{sources.add(path, {}), 0, 0, 0};
    auto text = expand_xacro(path, whole, diagnostics);
    if (!text) return std::nullopt;
    // Places are those of the expanded text.
    auto result = read_text(path + " (expanded)", std::move(*text), sources, diagnostics);
    if (result) result->file = std::filesystem::path(path).filename().string();
    return result;
  }
  const gen::Span place{sources.add(path, {}), 0, 0, 0};
  if (file.status == gen::LoadedFile::Status::too_large) {
    diagnostics.error("E0102", place, fmt::format("the file is larger than {} bytes", kMaxBytes));
  } else {
    diagnostics.io_error("E0101", place, fmt::format("cannot read `{}`: {}", path, file.reason))
        .help = gen::help_for_missing(path, path);
  }
  return std::nullopt;
}

}  // namespace eagerx::urdf
