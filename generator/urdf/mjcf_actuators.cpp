// Actuators of MJCF, as those of joints.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "generator/urdf/mjcf_joints.hpp"

namespace eagerx::urdf {
namespace {

constexpr double kNoBound = std::numeric_limits<double>::infinity();

/// force = gain·ctrl + bias − stiffness·length − damping·velocity.
struct Law {
  double gain = 1.0, bias = 0.0, stiffness = 0.0, damping = 0.0;
};

class Actuators {
 public:
  Actuators(Document& document, Description& description)
      : document_(document), description_(description) {}

  void read() {
    const auto all = document_.section("actuator");
    if (all.empty()) return;
    for (Joint& joint : description_.joints) joint.drive.exists = false;
    for (const pugi::xml_node one : all) add(Element(document_, one, document_.main_class()));
  }

 private:
  void add(const Element& element) {
    double gear = 1.0;
    Joint* const joint = joint_of(element, gear);
    if (joint == nullptr) return;
    if (joint->type == JointType::spherical || joint->type == JointType::floating) {
      element.error("E0851", element.span(), "only hinges and slides can have an actuator").help =
          "write a ball joint as three hinges in one body";
      return;
    }
    if (const auto law = law_of(element)) apply(element, *law, gear, *joint);
  }

  /// The joint that it moves; `gear` is the force on it for each of the actuator.
  Joint* joint_of(const Element& element, double& gear) {
    if (const auto gears = element.numbers("gear", 6); !gears.empty()) gear = gears[0];
    if (gear == 0.0)
      element.error("E0853", element.span("gear"), "the first number of `gear` cannot be 0");
    for (const char* const name : {"joint", "jointinparent"}) {
      if (element.has(name)) return find(element.text(name), element, name);
    }
    if (element.has("tendon")) return joint_of_tendon(element, gear);
    element.error("E0851", element.span(), fmt::format("`{}` does not move a joint", element.tag()))
        .help = "only actuators of joints are supported, and of tendons that move one joint";
    return nullptr;
  }

  Joint* find(const std::string& name, const Element& element, const char* attribute) {
    const auto known = std::ranges::find(description_.joints, name, &Joint::name);
    if (known != description_.joints.end()) return &*known;
    std::vector<std::string> names;
    for (const Joint& joint : description_.joints) names.push_back(joint.name);
    element.error("E0854", element.span(attribute), fmt::format("there is no joint `{}`", name))
        .help = gen::did_you_mean(name, names);
    return nullptr;
  }

  /// A fixed tendon of one joint, or of a joint and of those that follow it.
  Joint* joint_of_tendon(const Element& element, double& gear) {
    const std::string name = element.text("tendon");
    for (const pugi::xml_node one : document_.section("tendon")) {
      if (one.attribute("name").value() != name) continue;
      Joint* leader = nullptr;
      double sum = 0.0;
      if (std::string_view(one.name()) == "fixed" && sum_up(one, leader, sum) && sum != 0.0) {
        gear *= sum;
        return leader;
      }
      element
          .error("E0851", element.span("tendon"),
                 fmt::format("the tendon `{}` moves more than one joint", name))
          .notes.push_back({"the tendon", document_.xml(one).span(one), ""});
      return nullptr;
    }
    element.error("E0854", element.span("tendon"), fmt::format("there is no tendon `{}`", name));
    return nullptr;
  }

  bool sum_up(pugi::xml_node tendon, Joint*& leader, double& sum) {
    for (const pugi::xml_node part : document_.children(tendon)) {
      const Element element(document_, part, nullptr);
      Joint* joint = find(element.text("joint"), element, "joint");
      if (joint == nullptr) return false;
      double ratio = element.number("coef", 0.0);
      if (joint->mimic) {
        ratio *= joint->mimic->ratio;
        joint = find(joint->mimic->joint, element, "joint");
      }
      if (leader != nullptr && joint != leader) return false;
      leader = joint;
      sum += ratio;
    }
    return leader != nullptr;
  }

  std::optional<Law> law_of(const Element& element) {
    const std::string tag = element.tag();
    Law law;
    if (tag == "motor") return law;
    if (tag == "position") {
      law.gain = law.stiffness = element.not_negative("kp", 1.0);
      law.damping = element.not_negative("kv", 0.0);
      if (element.number("dampratio", 0.0) > 0.0)
        element
            .warning("E0851", element.span("dampratio"),
                     "`dampratio` depends on the inertia: the servo has no damping")
            .help = "write `kv`";
      note_dynamics(element, element.number("timeconst", 0.0) > 0.0 ? "timeconst" : "");
      return law;
    }
    if (tag == "velocity") {
      law.gain = law.damping = element.not_negative("kv", 1.0);
      return law;
    }
    if (tag == "general") return general(element);
    element
        .error("E0851", element.span(),
               fmt::format("actuators of kind `{}` are not supported", tag))
        .help = "`motor`, `position`, `velocity` and `general` are";
    return std::nullopt;
  }

  std::optional<Law> general(const Element& element) {
    const auto is_one_of = [&](const char* attribute, std::initializer_list<const char*> words) {
      const std::string word = element.text(attribute);
      if (word.empty() || std::ranges::find(words, word) != words.end()) return true;
      element.error("E0851", element.span(attribute),
                    fmt::format("`{}` `{}` is not supported", attribute, word));
      return false;
    };
    if (!is_one_of("gaintype", {"fixed"}) || !is_one_of("biastype", {"none", "affine"}) ||
        !is_one_of("dyntype", {"none", "filter", "filterexact"}))
      return std::nullopt;
    Law law;
    if (const auto gains = element.numbers("gainprm", 10); !gains.empty()) law.gain = gains[0];
    if (element.text("biastype") == "affine") {
      auto bias = element.numbers("biasprm", 10);
      bias.resize(10, 0.0);
      law.bias = bias[0];
      law.stiffness = -bias[1];
      law.damping = -bias[2];
    }
    const std::string dynamics = element.text("dyntype");
    note_dynamics(element, dynamics.empty() || dynamics == "none" ? "" : "dyntype");
    return law;
  }

  static void note_dynamics(const Element& element, const std::string& attribute) {
    if (attribute.empty()) return;
    element
        .warning("E0851", element.span(attribute.c_str()),
                 "the filter of its command is left out: it acts at once")
        .help = "a filter node in front of the actuator smooths commands";
  }

  struct Range {
    double low = -kNoBound, high = kNoBound;
    Range operator*(double s) const {
      return s < 0.0 ? Range{s * high, s * low} : Range{s * low, s * high};
    }
  };
  Range range_of(const Element& element, const char* attribute, const char* limited) {
    const auto range = element.numbers(attribute, 2);
    if (range.size() != 2 || range[0] >= range[1]) return {};
    if (!element.flag(limited).value_or(true)) return {};
    return {range[0], range[1]};
  }

  /// Stiffness and damping of a joint are those of the actuator times gear².
  void apply(const Element& element, const Law& law, double gear, Joint& joint) {
    if (law.gain == 0.0) {
      element.error("E0851", element.span(), "an actuator whose gain is 0 does not move its joint")
          .help = "write a spring or a damper as `stiffness` and `damping` of the joint";
      return;
    }
    if (joint.drive.exists) {
      element
          .warning(
              "E0851", element.span(),
              fmt::format("`{}` has another actuator already: this one is left out", joint.name))
          .help = "write a servo with damping as one `position` with `kp` and `kv`";
      return;
    }
    if (law.stiffness < 0.0 || law.damping < 0.0 || law.bias != 0.0) {
      element.error("E0851", element.span("biasprm"),
                    "`biasprm` has to be 0, then two numbers that are not above 0");
      return;
    }
    Drive& drive = joint.drive;
    drive.exists = true;
    const Range control = range_of(element, "ctrlrange", "ctrllimited");
    const Range force = range_of(element, "forcerange", "forcelimited") * gear;
    const double most = std::max(std::abs(force.low), std::abs(force.high));
    if (law.stiffness > 0.0) {
      add_servo(element, law, gear, joint);
      const Range target = control * (law.gain / (law.stiffness * gear));
      drive.position_low = std::max(target.low, drive.position_low);
      drive.position_high = std::min(target.high, drive.position_high);
      if (std::isfinite(most)) joint.effort = std::min(joint.effort, most);
    } else if (law.damping > 0.0) {
      if (std::isfinite(most)) joint.effort = std::min(joint.effort, most);
    } else {
      const Range torque = control * (law.gain * gear);
      drive.torque_low = std::max(torque.low, force.low);
      drive.torque_high = std::min(torque.high, force.high);
      const double strongest = std::max(std::abs(drive.torque_low), std::abs(drive.torque_high));
      if (std::isfinite(strongest)) joint.effort = std::min(joint.effort, strongest);
    }
  }

  void add_servo(const Element& element, const Law& law, double gear, Joint& joint) {
    joint.drive.stiffness = law.stiffness * gear * gear;
    joint.drive.damping = law.damping * gear * gear;
    const double inherited = element.number("inheritrange", 0.0);
    if (!(inherited > 0.0) || !std::isfinite(joint.lower) || !std::isfinite(joint.upper)) return;
    const double middle = 0.5 * (joint.lower + joint.upper);
    const double half = 0.5 * inherited * (joint.upper - joint.lower);
    joint.drive.position_low = middle - half;
    joint.drive.position_high = middle + half;
  }

  Document& document_;
  Description& description_;
};

}  // namespace

void read_actuators(Document& document, Description& description) {
  Actuators(document, description).read();
}

}  // namespace eagerx::urdf
