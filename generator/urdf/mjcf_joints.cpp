#include "generator/urdf/mjcf_joints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace eagerx::urdf {
namespace {

JointType type_of(const Element& element) {
  static const std::map<std::string, JointType> kTypes = {{"", JointType::continuous},
                                                          {"hinge", JointType::continuous},
                                                          {"slide", JointType::prismatic},
                                                          {"ball", JointType::spherical},
                                                          {"free", JointType::floating}};
  const std::string type = element.text("type");
  const auto known = kTypes.find(type);
  if (known != kTypes.end()) return known->second;
  element
      .error("E0851", element.span("type"),
             fmt::format("joints of type `{}` are not supported", type))
      .help = gen::did_you_mean(type, {"hinge", "slide", "ball", "free"});
  return JointType::continuous;
}

void set_stops(const Element& element, double unit, bool autolimits, Joint& joint) {
  const auto range = element.numbers("range", 2);
  const auto limited = element.flag("limited");
  if (range.size() != 2) {
    if (limited.value_or(false) || !range.empty())
      element.error(range.empty() ? "E0852" : "E0853",
                    range.empty() ? element.span() : element.span("range"),
                    "the `range` of a joint has to be two numbers");
    return;
  }
  if (!limited.value_or(autolimits)) return;
  if (!limited && range[0] == 0.0 && range[1] == 0.0) return;  // as without one
  if (joint.type == JointType::spherical) {
    element.warning("E0851", element.span("range"),
                    fmt::format("`{}` is a ball joint: its stops are left out", joint.name));
    return;
  }
  if (range[0] >= range[1]) {
    element.error("E0853", element.span("range"),
                  "`range` goes from the smaller to the larger number");
    return;
  }
  joint.lower = unit * range[0];
  joint.upper = unit * range[1];
}

void set_spring(const Element& element, double unit, Joint& joint) {
  joint.stiffness = element.not_negative("stiffness", 0.0);
  joint.rest = unit * element.number("springref", 0.0);
  if (joint.stiffness > 0.0 && joint.type == JointType::spherical)
    element.warning(
        "E0851", element.span("stiffness"),
        fmt::format("`{}` is a ball joint: its spring acts about each of three axes", joint.name));
  for (const double part : element.numbers("springdamper", 2)) {
    if (part <= 0.0) continue;
    element.error("E0851", element.span("springdamper"), "`springdamper` is not supported").help =
        "write `stiffness` and `damping`";
    return;
  }
}

void refuse_on_free(const Element& element, const Joint& joint) {
  const double values[] = {joint.damping, joint.friction, joint.armature, joint.stiffness};
  if (std::ranges::all_of(values, [](double value) { return value == 0.0; })) return;
  element.warning("E0851", element.span(),
                  "a free body has no damping, friction, armature and spring: they are left out");
}

}  // namespace

JointElement read_joint(const Element& element, const Compiler& compiler) {
  JointElement result;
  Joint& joint = result.joint;
  joint.name = element.text("name");
  joint.place = joint.parent_place = joint.child_place = element.span();
  if (element.tag() == "freejoint") {
    joint.type = JointType::floating;
    return result;
  }
  joint.type = type_of(element);
  const double unit = joint.type == JointType::prismatic ? 1.0 : compiler.angle;
  result.position = element.vector("pos", {});
  joint.axis = element.direction("axis", {{0.0, 0.0, 1.0}});
  result.reference = unit * element.number("ref", 0.0);
  joint.damping = element.not_negative("damping", 0.0);
  joint.friction = element.not_negative("frictionloss", 0.0);
  joint.armature = element.not_negative("armature", 0.0);
  set_spring(element, unit, joint);
  if (joint.type == JointType::floating) {
    refuse_on_free(element, joint);
    result.position = {};
    return result;
  }
  set_stops(element, unit, compiler.autolimits, joint);
  const auto force = element.numbers("actuatorfrcrange", 2);
  if (force.size() == 2 && element.flag("actuatorfrclimited").value_or(compiler.autolimits))
    joint.effort = std::max(std::abs(force[0]), std::abs(force[1]));
  return result;
}

namespace {

Joint* find_joint(Description& description, const Element& element, const char* attribute) {
  const std::string name = element.text(attribute);
  const auto known = std::ranges::find(description.joints, name, &Joint::name);
  if (known != description.joints.end()) return &*known;
  std::vector<std::string> names;
  for (const Joint& joint : description.joints) names.push_back(joint.name);
  element
      .error(name.empty() ? "E0852" : "E0854",
             name.empty() ? element.span() : element.span(attribute),
             name.empty() ? fmt::format("`{}` has no attribute `{}`", element.tag(), attribute)
                          : fmt::format("there is no joint `{}`", name))
      .help = gen::did_you_mean(name, names);
  return nullptr;
}

void read_follower(const Element& element, Description& description) {
  Joint* const follower = find_joint(description, element, "joint1");
  if (follower == nullptr) return;
  if (!element.has("joint2")) {
    element.error("E0851", element.span(), "a joint that an equality holds still is not supported")
        .help = "take the joint out of its body";
    return;
  }
  const Joint* const leader = find_joint(description, element, "joint2");
  if (leader == nullptr) return;
  std::vector<double> polynomial = element.numbers("polycoef", 5);
  if (polynomial.empty()) polynomial = {0.0, 1.0};
  polynomial.resize(5, 0.0);
  if (polynomial[2] != 0.0 || polynomial[3] != 0.0 || polynomial[4] != 0.0) {
    element.error("E0851", element.span("polycoef"),
                  "a joint can follow another one in proportion only: the last three have to be 0");
    return;
  }
  follower->mimic = {leader->name, element.span("joint2"), polynomial[1], polynomial[0]};
}

}  // namespace

void read_equalities(Document& document, Description& description) {
  for (const pugi::xml_node one : document.section("equality")) {
    const Element element(document, one, document.main_class());
    if (!element.flag("active").value_or(true)) continue;
    if (element.tag() == "joint") {
      read_follower(element, description);
    } else {
      element
          .error("E0851", element.span(),
                 fmt::format("`{}` in `equality` is not supported", element.tag()))
          .help = "joints must make a tree; of `equality`, `joint` is read";
    }
  }
}

}  // namespace eagerx::urdf
