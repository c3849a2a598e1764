// Reads the tree of bodies, and the settings that apply to all of them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "generator/support/diagnostics/join.hpp"
#include "generator/urdf/mjcf.hpp"
#include "generator/urdf/mjcf_geoms.hpp"
#include "generator/urdf/mjcf_joints.hpp"
#include "generator/urdf/mjcf_sections.hpp"

namespace eagerx::urdf {
namespace {

constexpr std::size_t kMostItems = 1'000;  // bodies, and joints
constexpr std::size_t kDeepest = 200;      // bodies in bodies

/// Parts of one body, with their places in the body's frame.
struct Part {
  pugi::xml_node node;
  Frame frame;
  const DefaultClass* defaults;
};
using Parts = std::vector<Part>;

class MjcfReader {
 public:
  MjcfReader(Document& document, gen::Diagnostics& diagnostics)
      : document_(document),
        diagnostics_(diagnostics),
        compiler_(read_compiler(document)),
        geoms_(document, compiler_) {}

  Description read() {
    result_.name = document_.root().attribute("model").value();
    result_.place = document_.xml(document_.root()).span(document_.root());
    result_.has_world = true;
    document_.read_defaults();
    geoms_.read_meshes();
    const Disabled off = read_options(document_, result_);
    find_ground();
    if (off.contact) ground_type_ = ground_affinity_ = 0;
    find_names();
    read_world();
    scale_masses();
    disable(off, result_);
    if (!off.equality) read_equalities(document_, result_);
    subtract_references();
    read_actuators(document_, result_);
    read_contacts(document_, result_);
    add_drawn();
    read_keyframes(document_, result_);
    refuse_rest(document_, compiler_);
    report();
    return std::move(result_);
  }

 private:
  gen::Diagnostic& error(const char* code, pugi::xml_node at, std::string message) {
    return document_.xml(at).error(code, document_.xml(at).span(at), std::move(message));
  }

  /// Geoms touch the ground by `contype` and `conaffinity` of the planes.
  void find_ground() {
    for (const pugi::xml_node one : document_.section("worldbody")) {
      if (std::string_view(one.name()) != "geom") continue;
      const Element element(document_, one, document_.main_class());
      if (element.text("type") != "plane") continue;
      if (!has_ground_) ground_type_ = ground_affinity_ = 0;
      has_ground_ = true;
      ground_type_ |= bits_of(element, "contype");
      ground_affinity_ |= bits_of(element, "conaffinity");
    }
  }
  bool touches(const Geom& geom) const {
    return (geom.type & ground_affinity_) != 0 || (geom.affinity & ground_type_) != 0;
  }

  /// Collects the elements of a body or the world, including those inside `frame` elements.
  void gather(pugi::xml_node from, const Frame& frame, const DefaultClass* defaults, Parts& parts,
              std::size_t depth = 0) {
    document_.check(from);
    if (depth > kDeepest) return refuse_large(document_.xml(from).span(from));
    for (const pugi::xml_node child : document_.children(from)) {
      if (std::string_view(child.name()) != "frame") {
        parts.push_back({child, frame, defaults});
        continue;
      }
      const DefaultClass* const inner = class_in(child, defaults);
      gather(child, frame * frame_of(Element(document_, child, nullptr), compiler_), inner, parts,
             depth + 1);
    }
  }
  const DefaultClass* class_in(pugi::xml_node node, const DefaultClass* around) {
    return node.attribute("childclass") ? document_.find_class(node, "childclass") : around;
  }

  void read_world() {
    Link world;
    world.name = "world";
    world.place = result_.place;
    links_.taken.insert(world.name);
    result_.links.push_back(std::move(world));
    for (const pugi::xml_node one : document_.sections()) {
      if (std::string_view(one.name()) != "worldbody") continue;
      Parts parts;
      gather(one, {}, class_in(one, document_.main_class()), parts);
      read_parts(parts, 0, {}, 0);
    }
  }

  /// Geoms and bodies in the link, whose frame is at `shift` in that of the body.
  void read_parts(const Parts& parts, std::size_t link, const Vector3& shift, std::size_t depth) {
    const Frame back{-1.0 * shift, models::kNoRotation};
    const bool has_own_inertia =
        std::ranges::any_of(parts, [](const Part& part) { return is(part, "inertial"); });
    const bool of_geoms = compiler_.inertia_from_geoms.value_or(!has_own_inertia) && link != 0;
    std::vector<MassAndInertia> masses;
    for (const Part& part : parts) {
      if (is(part, "geom")) {
        const Element element(document_, part.node, part.defaults);
        const Geom geom = geoms_.read(element, back * part.frame, of_geoms);
        if (geom.inertial) masses.push_back(turned(*geom.inertial, {}));
        if (geom.shape && touches(geom))
          result_.links[link].collisions.push_back(*geom.shape);
        else if (geom.shape)
          ++untouched_;
      } else if (is(part, "inertial") && !of_geoms) {
        set_inertial(part, back, link);
      } else if (is(part, "body")) {
        read_body(part, link, back, depth + 1);
      } else if (!is(part, "joint") && !is(part, "freejoint") && !is_drawn(part)) {
        refuse(part.node);
      }
    }
    if (!masses.empty()) set_masses(masses, link);
    if (link != 0) bound(result_.links[link]);
  }
  static bool is(const Part& part, std::string_view tag) { return part.node.name() == tag; }
  static bool is_drawn(const Part& part) {
    return is(part, "site") || is(part, "camera") || is(part, "light") || is(part, "inertial");
  }
  void refuse(pugi::xml_node node) {
    const std::string_view tag = node.name();
    for (const char* const known : {"composite", "flexcomp", "replicate", "attach", "plugin"}) {
      if (tag == known)
        error("E0851", node, fmt::format("`{}` is not supported", tag)).help =
            tag == "replicate" || tag == "attach" ? "let MuJoCo write it out: `mj_saveLastXML`"
                                                  : "only rigid bodies can be simulated";
    }
  }

  void set_inertial(const Part& part, const Frame& back, std::size_t link) {
    const Element element(document_, part.node, nullptr);
    Inertial result;
    result.origin = back * part.frame * frame_of(element, compiler_);
    if (!element.has("mass"))
      element.error("E0852", element.span(), "`inertial` has no attribute `mass`");
    result.mass = element.not_negative("mass", 0.0);
    if (element.has("fullinertia")) {
      auto six = element.numbers("fullinertia", 6);
      if (six.size() != 6)
        element.error("E0853", element.span("fullinertia"), "`fullinertia` has to be six numbers");
      six.resize(6, 0.0);
      result.inertia = {{six[0], six[1], six[2]}};
      result.products = {{six[3], six[4], six[5]}};
    } else if (element.has("diaginertia")) {
      result.inertia = element.vector("diaginertia", {});
    } else {
      element.error("E0852", element.span(),
                    "`inertial` has no `diaginertia` and no `fullinertia`");
    }
    result_.links[link].inertial = result;
    result_.links[link].inertial_place = element.span();
  }

  void set_masses(const std::vector<MassAndInertia>& masses, std::size_t link) {
    const MassAndInertia all = together(masses);
    Inertial result;
    result.mass = all.mass;
    result.origin.position = all.centre;
    result.inertia = all.inertia;
    result.products = all.products;
    result_.links[link].inertial = result;
    result_.links[link].inertial_place = result_.links[link].place;
  }

  /// `boundmass`, `boundinertia` and `balanceinertia` of `compiler`.
  void bound(Link& link) const {
    if (!link.inertial) {
      if (compiler_.least_mass > 0.0 || compiler_.least_inertia > 0.0) link.inertial.emplace();
      if (!link.inertial) return;
    }
    Inertial& of = *link.inertial;
    of.mass = std::max(of.mass, compiler_.least_mass);
    Vector3& i = of.inertia;
    for (std::size_t k = 0; k < 3; ++k) i[k] = std::max(i[k], compiler_.least_inertia);
    const bool is_none = i[0] + i[1] < i[2] || i[0] + i[2] < i[1] || i[1] + i[2] < i[0];
    if (!compiler_.balances_inertia || !is_none) return;
    const double mean = (i[0] + i[1] + i[2]) / 3.0;
    i = {{mean, mean, mean}};
  }

  struct TakenNames {
    std::set<std::string> written;  // in the description, whether read yet or not
    std::set<std::string> taken;
  };
  /// Names that are made differ from all that are written.
  void find_names() {
    std::vector<pugi::xml_node> rest = document_.section("worldbody");
    while (!rest.empty()) {
      const pugi::xml_node node = rest.back();
      rest.pop_back();
      const std::string_view tag = node.name();
      if (tag == "body") links_.written.insert(node.attribute("name").value());
      if (tag == "joint" || tag == "freejoint")
        joints_.written.insert(node.attribute("name").value());
      if (tag != "body" && tag != "frame") continue;
      const std::vector<pugi::xml_node> inside = document_.children(node);
      rest.insert(rest.end(), inside.begin(), inside.end());
    }
  }
  static std::string unique(const std::string& name, TakenNames& names) {
    std::string result = name;
    for (int i = 2; names.written.contains(result) || !names.taken.insert(result).second; ++i)
      result = fmt::format("{}_{}", name, i);
    return result;
  }

  std::size_t add_link(std::string name, gen::Span place) {
    Link link;
    link.name = std::move(name);
    link.place = place;
    result_.links.push_back(std::move(link));
    return result_.links.size() - 1;
  }

  std::string name_of_body(const Element& element) {
    std::string name = element.text("name");
    if (name.empty()) return unique("body", links_);
    if (!links_.taken.insert(name).second)
      element.error("E0854", element.span("name"), fmt::format("there is another body `{}`", name));
    return name;
  }

  void refuse_large(gen::Span place) {
    if (!std::exchange(is_too_large_, true))
      diagnostics_.error("E0851", place,
                         fmt::format("there are more than {} bodies or joints, or {} in each other",
                                     kMostItems, kDeepest));
  }

  void read_body(const Part& part, std::size_t parent, const Frame& back, std::size_t depth) {
    const Element element(document_, part.node, nullptr);
    if (depth > kDeepest || result_.links.size() > kMostItems) return refuse_large(element.span());
    const std::string name = name_of_body(element);
    const gen::Span place = element.has("name") ? element.span("name") : element.span();
    if (element.number("gravcomp", 0.0) != 0.0 && gravity_compensated_++ == 0)
      gravity_compensation_ = element.span("gravcomp");
    Parts parts;
    gather(part.node, {}, class_in(part.node, part.defaults), parts);
    const Frame frame = back * part.frame * frame_of(element, compiler_);
    const auto [link, shift] = add_joints(parts, name, place, parent, frame);
    read_parts(parts, link, shift, depth);
  }

  struct Placed {
    std::size_t link;
    Vector3 shift;  // of its frame in the body's
  };
  /// A link for each joint; the last one is the body.
  Placed add_joints(const Parts& parts, const std::string& name, gen::Span place,
                    std::size_t parent, const Frame& frame) {
    std::vector<JointElement> joints;
    for (const Part& part : parts) {
      if (!is(part, "joint") && !is(part, "freejoint")) continue;
      const Element element(document_, part.node, part.defaults);
      if (result_.joints.size() + joints.size() > kMostItems) {
        refuse_large(element.span());
        break;
      }
      JointElement joint = read_joint(element, compiler_);
      joint.position = part.frame.position + rotate(part.frame.rotation, joint.position);
      joint.joint.axis = rotate(part.frame.rotation, joint.joint.axis);
      if (joint.joint.name.empty()) joint.joint.name = name;
      joint.joint.name = name_of_joint(std::move(joint.joint.name), element);
      if (joint.joint.type == JointType::floating && (parent != 0 || parts_have_other(parts, part)))
        element.error("E0851", element.span(),
                      "only a body in `worldbody` can be free, and it has no other joint");
      joints.push_back(std::move(joint));
    }
    if (joints.empty()) {
      JointElement fixed;
      fixed.joint.name = unique(name + "_fixed", joints_);
      fixed.joint.place = place;
      joints.push_back(std::move(fixed));
    }
    return chain(std::move(joints), name, place, parent, frame);
  }
  static bool parts_have_other(const Parts& parts, const Part& joint) {
    return std::ranges::any_of(parts, [&](const Part& other) {
      return (is(other, "joint") || is(other, "freejoint")) && other.node != joint.node;
    });
  }
  std::string name_of_joint(std::string name, const Element& element) {
    if (!element.has("name")) return unique(name, joints_);
    if (!joints_.taken.insert(name).second)
      element.error("E0854", element.span("name"),
                    fmt::format("there is another joint `{}`", name));
    return name;
  }

  Placed chain(std::vector<JointElement> joints, const std::string& name, gen::Span place,
               std::size_t parent, const Frame& frame) {
    Placed at{parent, {}};
    for (std::size_t i = 0; i < joints.size(); ++i) {
      auto& [joint, position, reference] = joints[i];
      const bool is_last = i + 1 == joints.size();
      joint.parent = result_.links[at.link].name;
      joint.origin = i == 0 ? frame * Frame{position, models::kNoRotation}
                            : Frame{position - at.shift, models::kNoRotation};
      // The description draws the joint where its position is the reference.
      const Vector3 axis = rotate(joint.origin.rotation, joint.axis);
      if (joint.type == JointType::prismatic)
        joint.origin.position = joint.origin.position - reference * axis;
      else if (reference != 0.0)
        joint.origin.rotation = models::normalised(
            product(joint.origin.rotation, models::rotation(joint.axis, -reference)));
      references_[joint.name] = reference;
      at = {is_last ? add_link(name, place)
                    : add_link(unique(joint.name + "_link", links_), joint.place),
            position};
      if (!is_last) {
        result_.links.back().is_made = true;
        result_.links.back().share = kSmallShare;
      }
      joint.child = result_.links[at.link].name;
      result_.joints.push_back(std::move(joint));
    }
    return at;
  }

  /// `settotalmass` of `compiler`.
  void scale_masses() {
    double total = 0.0;
    for (const Link& link : result_.links) total += link.inertial ? link.inertial->mass : 0.0;
    if (!(compiler_.total_mass > 0.0) || !(total > 0.0)) return;
    const double factor = compiler_.total_mass / total;
    for (Link& link : result_.links) {
      if (!link.inertial) continue;
      link.inertial->mass *= factor;
      link.inertial->inertia = factor * link.inertial->inertia;
      link.inertial->products = factor * link.inertial->products;
    }
  }

  /// Polynomials of equalities are about the references.
  void subtract_references() {
    for (Joint& joint : result_.joints) {
      if (joint.mimic)
        joint.mimic->offset +=
            references_[joint.name] - joint.mimic->ratio * references_[joint.mimic->joint];
    }
  }

  /// Where joints begin in MuJoCo, if they do not begin at 0.
  void add_drawn() {
    Keyframe drawn{"drawn", {}};
    for (const auto& [name, reference] : references_) {
      if (reference != 0.0) drawn.positions[name] = reference;
    }
    if (!drawn.positions.empty()) result_.keyframes.push_back(std::move(drawn));
  }

  void report() {
    if (untouched_ > 0)
      diagnostics_.note(
          result_.place,
          fmt::format("{} not touch the ground, by `contype` and `conaffinity`",
                      untouched_ == 1 ? "1 geom does" : fmt::format("{} geoms do", untouched_)));
    if (gravity_compensated_ > 0)
      diagnostics_
          .warning("E0851", gravity_compensation_,
                   fmt::format("`gravcomp` of {} is left out",
                               gen::counted(gravity_compensated_, "body", "bodies")))
          .help = "the node GravityCompensation calculates such torques";
    document_.report_left_out();
  }

  Document& document_;
  gen::Diagnostics& diagnostics_;
  Compiler compiler_;
  Geoms geoms_;
  Description result_;
  TakenNames links_, joints_;
  std::map<std::string, double> references_;
  unsigned ground_type_ = 1, ground_affinity_ = 1;
  bool has_ground_ = false, is_too_large_ = false;
  std::size_t untouched_ = 0, gravity_compensated_ = 0;
  gen::Span gravity_compensation_;
};

}  // namespace

Description read_mjcf(const std::string& path, Xml& xml, pugi::xml_node root,
                      gen::SourceMap& sources, gen::Diagnostics& diagnostics) {
  Document document(path, xml, root, sources, diagnostics);
  if (document.refuse_if_large(xml.span(root))) return {};
  return MjcfReader(document, diagnostics).read();
}

}  // namespace eagerx::urdf
