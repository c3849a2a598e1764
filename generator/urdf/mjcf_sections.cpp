#include "generator/urdf/mjcf_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace eagerx::urdf {
namespace {

gen::Diagnostic& unsupported(Document& document, pugi::xml_node at, std::string message) {
  Xml& xml = document.xml(at);
  return xml.error("E0851", xml.span(at), std::move(message));
}

void read_flags(Document& document, pugi::xml_node flag, Description& description, Disabled& off) {
  if (std::string_view(flag.name()) != "flag") return;
  for (const pugi::xml_attribute attribute : flag.attributes()) {
    const std::string_view name = attribute.name(), word = attribute.value();
    if (word != "disable") continue;
    const auto is = [&](std::initializer_list<std::string_view> names) {
      return std::ranges::find(names, name) != names.end();
    };
    if (is({"gravity"})) description.gravity = Vector3{};
    if (is({"contact", "constraint"})) off.contact = true;
    if (is({"limit", "constraint"})) off.limit = true;
    if (is({"frictionloss", "constraint"})) off.friction = true;
    if (is({"equality", "constraint"})) off.equality = true;
    if (is({"spring", "passive"})) off.spring = true;
    if (is({"damper", "passive"})) off.damper = true;
    if (!is({"actuation", "clampctrl"})) continue;
    document.xml(flag).error("E0851", document.xml(flag).span(flag, attribute.name()),
                             fmt::format("a robot without `{}` is not supported", name));
  }
}

/// Air hardly changes the motion of a robot, a liquid does.
void check_medium(const Element& option) {
  constexpr double kAirDensity = 2.0, kAirViscosity = 1e-4;  // [kg/m³], [Pa·s], more than air has
  const double density = option.number("density", 0.0), viscosity = option.number("viscosity", 0.0);
  if (!(density > 0.0) && !(viscosity > 0.0)) return;
  const gen::Span place = option.span(density > 0.0 ? "density" : "viscosity");
  if (density <= kAirDensity && viscosity <= kAirViscosity) {
    option.warning("E0851", place, "the drag of air is left out");
    return;
  }
  option.error("E0851", place, "no engine simulates a fluid around a robot").help =
      "leave out `density` and `viscosity` of `option`";
}

/// Spheres and capsules touch each other; what is of the world touches as all else does.
void add_pair(const Element& element, const std::string& first, const std::string& second,
              Description& description) {
  std::size_t round = 0;
  for (std::size_t i = 1; i < description.links.size(); ++i) {
    for (const Collision& one : description.links[i].collisions) {
      if (one.name != first && one.name != second) continue;
      round += !one.mesh &&
               (one.kind == models::ShapeKind::sphere || one.kind == models::ShapeKind::capsule);
    }
  }
  const auto& world = description.links[0].collisions;
  const auto is_of_world = [&](const Collision& one) {
    return one.name == first || one.name == second;
  };
  if (round == 2) {
    description.pairs.push_back({first, second, element.span()});
  } else if (!std::ranges::any_of(world, is_of_world)) {
    element.warning("E0851", element.span(),
                    fmt::format("`{}` and `{}` do not touch each other: only spheres and "
                                "capsules that touch the ground can be a pair",
                                first, second));
  }
}

/// One that pulls changes the motion.
void check_tendon(const Element& tendon, const Compiler& compiler) {
  for (const char* const name : {"stiffness", "damping", "frictionloss", "armature"}) {
    const auto values = tendon.numbers(name, 3);
    if (std::ranges::any_of(values, [](double value) { return value > 0.0; }))
      tendon.error("E0851", tendon.span(name),
                   fmt::format("tendons with `{}` are not supported", name));
  }
  if (tendon.flag("limited").value_or(tendon.has("range") && compiler.autolimits))
    tendon.error("E0851", tendon.has("range") ? tendon.span("range") : tendon.span(),
                 "tendons with limits are not supported");
}

}  // namespace

Disabled read_options(Document& document, Description& description) {
  Disabled off;
  for (const pugi::xml_node one : document.sections()) {
    if (std::string_view(one.name()) != "option") continue;
    Xml& xml = document.xml(one);
    xml.check(one, {.attributes = {"gravity", "wind", "magnetic", "density", "viscosity"},
                    .many = {"flag"},
                    .ignored_attributes = {"timestep",
                                           "integrator",
                                           "solver",
                                           "iterations",
                                           "tolerance",
                                           "cone",
                                           "jacobian",
                                           "impratio",
                                           "ls_iterations",
                                           "ls_tolerance",
                                           "noslip_iterations",
                                           "noslip_tolerance",
                                           "mpr_iterations",
                                           "mpr_tolerance",
                                           "ccd_iterations",
                                           "ccd_tolerance",
                                           "apirate",
                                           "collision",
                                           "actuatorgroupdisable",
                                           "o_margin",
                                           "o_solref",
                                           "o_solimp",
                                           "o_friction",
                                           "sdf_iterations",
                                           "sdf_initpoints",
                                           "sleep_tolerance"}});
    const Element element(document, one, nullptr);
    if (element.has("gravity")) description.gravity = element.vector("gravity", {});
    check_medium(element);
    for (const pugi::xml_node flag : document.children(one))
      read_flags(document, flag, description, off);
  }
  return off;
}

void disable(const Disabled& disabled, Description& description) {
  for (Joint& joint : description.joints) {
    if (disabled.limit) joint.lower = -std::numeric_limits<double>::infinity();
    if (disabled.limit) joint.upper = std::numeric_limits<double>::infinity();
    if (disabled.friction) joint.friction = 0.0;
    if (disabled.spring) joint.stiffness = 0.0;
    if (disabled.damper) joint.damping = 0.0;
  }
}

void read_contacts(Document& document, Description& description) {
  for (const pugi::xml_node one : document.section("contact")) {
    if (std::string_view(one.name()) != "pair") continue;
    const Element element(document, one, document.main_class());
    add_pair(element, element.text("geom1"), element.text("geom2"), description);
  }
}

void read_keyframes(Document& document, Description& description) {
  for (const pugi::xml_node one : document.section("keyframe")) {
    const Element element(document, one, nullptr);
    const auto numbers = element.numbers("qpos", 10'000);
    Keyframe frame;
    frame.name = element.text("name").empty() ? "key" : element.text("name");
    std::size_t at = 0;
    for (const Joint& joint : description.joints) {
      const std::size_t size = joint.type == JointType::floating    ? 7
                               : joint.type == JointType::spherical ? 4
                               : joint.type == JointType::fixed     ? 0
                                                                    : 1;
      if (size == 1 && at < numbers.size()) frame.positions[joint.name] = numbers[at];
      at += size;
    }
    if (!numbers.empty()) description.keyframes.push_back(std::move(frame));
  }
}

void refuse_rest(Document& document, const Compiler& compiler) {
  check_sections(document.xml(document.root()), document.root());
  for (const pugi::xml_node one : document.section("deformable")) {
    if (std::string_view(one.name()) != "skin")
      unsupported(document, one, fmt::format("`{}` is not supported", one.name())).help =
          "only rigid bodies can be simulated";
  }
  for (const pugi::xml_node one : document.section("asset")) {
    if (std::string_view(one.name()) == "model")
      unsupported(document, one, "models in models are not supported").help =
          "let MuJoCo write them out: `mj_saveLastXML`";
  }
  for (const pugi::xml_node one : document.section("tendon"))
    check_tendon(Element(document, one, document.main_class()), compiler);
}

}  // namespace eagerx::urdf
