#include "generator/urdf/robot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "generator/backend/emit/namer.hpp"
#include "generator/frontend/spec/format.hpp"
#include "generator/urdf/inertia.hpp"
#include "generator/urdf/masses.hpp"

namespace eagerx::urdf {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

/// Only letters, digits and single `_`, a letter in front: a name in graphs and in C++. Empty for
/// an empty one.
std::string identifier(std::string_view name) {
  // With what is put behind it, such as `_contact`, it is not too long.
  constexpr std::size_t kLongest = gen::kLongestName - 20;
  std::string result;
  for (const char c : name.substr(0, kLongest)) {
    const bool kept = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (kept)
      result += c;
    else if (!result.empty() && result.back() != '_')
      result += '_';
  }
  if (result.ends_with('_')) result.pop_back();
  if (!name.empty() && !gen::is_identifier(result)) result.insert(0, result.empty() ? "n" : "n_");
  return result;
}

class Maker {
 public:
  Maker(const Description& from, const RobotOptions& options, gen::Diagnostics& diagnostics)
      : from_(from), options_(options), diagnostics_(diagnostics) {}

  std::optional<Robot> make() {
    const std::size_t before = diagnostics_.error_count();
    index_links();
    connect();
    const std::size_t root = find_root();
    if (diagnostics_.error_count() > before) return std::nullopt;
    name_robot();
    place_links(root);
    share_stops();
    finish_bodies();
    pair_shapes();
    if (diagnostics_.error_count() > before) return std::nullopt;
    robot_.ground = options_.ground;
    return std::move(robot_);
  }

 private:
  gen::Diagnostic& error(const char* code, gen::Span place, std::string message) {
    return diagnostics_.error(code, place, std::move(message));
  }

  /// Names as they are in generated code, each only once: of two that would be the same the later
  /// one gets a number.
  using Names = std::map<std::string, std::string>;
  template <class Items>
  void index(const Items& items, const char* kind, std::map<std::string, std::size_t>& result,
             Names& generated) {
    std::set<std::string> taken;
    for (std::size_t i = 0; i < items.size(); ++i) {
      const auto [other, is_new] = result.emplace(items[i].name, i);
      if (!is_new) {
        error("E0854", items[i].place, fmt::format("there is another {} `{}`", kind, items[i].name))
            .notes.push_back({"the first one", items[other->second].place, ""});
        continue;
      }
      generated[items[i].name] = unique(identifier(items[i].name), taken);
    }
  }

  static std::string unique(std::string name, std::set<std::string>& taken) {
    std::string result = name;
    for (int i = 2; !taken.insert(result).second; ++i) result = fmt::format("{}_{}", name, i);
    return result;
  }

  void index_links() {
    index(from_.links, "link", links_, link_names_);
    index(from_.joints, "joint", joints_, joint_names_);
  }

  std::size_t link(const std::string& name, gen::Span place) {
    const auto found = links_.find(name);
    if (found != links_.end()) return found->second;
    auto& unknown = error("E0854", place, fmt::format("there is no link `{}`", name));
    std::vector<std::string> names;
    for (const Link& item : from_.links) names.push_back(item.name);
    unknown.help = gen::did_you_mean(name, names);
    return kNone;
  }

  void connect() {
    joints_from_.resize(from_.links.size());
    joint_to_.resize(from_.links.size(), kNone);
    for (std::size_t j = 0; j < from_.joints.size(); ++j) {
      const Joint& joint = from_.joints[j];
      const std::size_t parent = link(joint.parent, joint.parent_place);
      const std::size_t child = link(joint.child, joint.child_place);
      if (parent == kNone || child == kNone) continue;
      if (joint_to_[child] != kNone) {
        error("E0855", joint.child_place, fmt::format("`{}` hangs on two joints", joint.child))
            .notes.push_back({"the other one", from_.joints[joint_to_[child]].child_place, ""});
        continue;
      }
      joint_to_[child] = j;
      joints_from_[parent].push_back(j);
    }
  }

  std::size_t find_root() {
    std::size_t root = kNone;
    for (std::size_t i = 0; i < from_.links.size(); ++i) {
      if (joint_to_[i] != kNone) continue;
      if (root == kNone) {
        root = i;
      } else {
        error("E0855", from_.links[i].place,
              fmt::format("`{}` hangs on no joint", from_.links[i].name))
            .notes.push_back({"only one link can be the first", from_.links[root].place, ""});
      }
    }
    if (from_.links.empty()) {
      error("E0855", from_.place, "the robot has no link");
    } else if (root == kNone) {
      error("E0855", from_.links[0].place, "no link is the first: joints make a ring");
    } else {
      refuse_rings(root);
    }
    return root;
  }

  void refuse_rings(std::size_t root) {
    std::vector<bool> reached(from_.links.size());
    std::vector<std::size_t> open = {root};
    while (!open.empty()) {
      const std::size_t i = open.back();
      open.pop_back();
      reached[i] = true;
      for (const std::size_t j : joints_from_[i]) open.push_back(links_.at(from_.joints[j].child));
    }
    for (std::size_t i = 0; i < reached.size(); ++i) {
      if (reached[i] || joint_to_[i] == kNone) continue;
      error("E0855", from_.links[i].place,
            fmt::format("`{}` is in a ring of joints", from_.links[i].name));
      return;
    }
  }

  void name_robot() {
    robot_.file = from_.file;
    robot_.links = static_cast<std::size_t>(
        std::ranges::count_if(from_.links, [](const Link& item) { return !item.is_made; }));
    if (from_.has_world) --robot_.links;
    robot_.id = options_.id.empty() ? gen::camel(identifier(from_.name)) : options_.id;
    if (robot_.id.empty() || (robot_.id[0] >= '0' && robot_.id[0] <= '9') || robot_.id == "Io")
      robot_.id.insert(0, "Robot");
    robot_.name = gen::snake(identifier(from_.name));
    if (robot_.name.empty()) robot_.name = "robot";
    robot_.has_world = from_.has_world;
    robot_.gravity = from_.gravity.value_or(robot_.gravity);
    for (const Keyframe& frame : from_.keyframes) {
      Keyframe& named = robot_.keyframes.emplace_back();
      named.name = identifier(frame.name);
      for (const auto& [joint, value] : frame.positions)
        named.positions[joint_names_.at(joint)] = value;
    }
  }

  /// Pairs that the description names by its own names.
  void pair_shapes() {
    for (const TouchingPair& pair : from_.pairs) {
      const auto first = names_of_collisions_.find(pair.first);
      const auto second = names_of_collisions_.find(pair.second);
      if (first != names_of_collisions_.end() && second != names_of_collisions_.end())
        robot_.pairs.push_back({first->second, second->second});
    }
  }

  /// A link and what it belongs to: a body, or kNone for the world.
  struct Placed {
    std::size_t link;
    Frame frame;
    std::size_t body;
  };

  /// All links, parents first, joints of a link in the order of the file.
  void place_links(std::size_t root) {
    const Link& first = from_.links[root];
    robot_.base = link_names_.at(first.name);
    const bool is_fixed =
        options_.base == Base::fixed || (options_.base == Base::by_mass && !has_free_base(root));
    std::vector<Placed> open = {{root, {}, is_fixed ? kNone : new_body(first, {}, true)}};
    while (!open.empty()) {
      Placed now = open.back();
      open.pop_back();
      add_link(now);
      const auto& joints = joints_from_[now.link];
      for (std::size_t i = joints.size(); i-- > 0;)
        open.push_back(follow(now, from_.joints[joints[i]]));
    }
  }

  /// Whether the base floats. A root link without mass, as ROS recommends, floats if a link with
  /// mass is fixed to it, unless its name says that it is the world.
  bool has_free_base(std::size_t root) const {
    const Link& first = from_.links[root];
    if (!first.inertial && (first.name == "world" || first.name == "map" || first.name == "odom"))
      return false;
    std::vector<std::size_t> open = {root};
    while (!open.empty()) {
      const std::size_t i = open.back();
      open.pop_back();
      if (from_.links[i].inertial && from_.links[i].inertial->mass > 0.0) return true;
      for (const std::size_t j : joints_from_[i]) {
        if (from_.joints[j].type == JointType::fixed)
          open.push_back(links_.at(from_.joints[j].child));
      }
    }
    return false;
  }

  std::size_t new_body(const Link& link, const Vector3& place, bool is_free) {
    robot_.bodies.push_back({.name = link_names_.at(link.name), .place = link.place});
    robot_.bodies.back().is_free = is_free;
    robot_.bodies.back().is_made = link.is_made;
    robot_.bodies.back().share = link.share;
    parts_.emplace_back();
    places_.push_back(place);
    return robot_.bodies.size() - 1;
  }

  std::string body_name(std::size_t body) const {
    return body == kNone ? std::string() : robot_.bodies[body].name;
  }

  Placed follow(const Placed& parent, const Joint& joint) {
    const std::size_t link = links_.at(joint.child);
    return {link, parent.frame * joint.origin, parent.body};
  }

  void add_link(Placed& now) {
    const Link& link = from_.links[now.link];
    if (joint_to_[now.link] != kNone) add_joint(from_.joints[joint_to_[now.link]], now);
    if (link.inertial && now.body != kNone)
      parts_[now.body].push_back(turned(*link.inertial, now.frame));
    std::size_t count = 0;
    for (const Collision& collision : link.collisions) {
      ++count;
      const Frame frame = now.frame * collision.origin;
      std::string name = identifier(collision.name);
      if (name.empty())
        name = link_names_.at(link.name) + (count > 1 ? fmt::format("_{}", count) : "");
      name = unique(std::move(name), shape_names_);
      if (!collision.name.empty()) names_of_collisions_.emplace(collision.name, name);
      robot_.shapes.push_back({std::move(name), collision.kind, body_name(now.body), collision.size,
                               frame.position, frame.rotation,
                               rotate(frame.rotation, collision.normal), collision.friction});
      if (collision.kind == models::ShapeKind::plane && now.body != kNone)
        error("E0851", collision.place, "a plane is part of the world: it cannot move");
      bodies_of_shapes_.push_back(now.body);
    }
    for (std::size_t t = 0; t + 2 < link.look.size(); t += 3) {
      Facet facet{.body = body_name(now.body)};
      for (std::size_t i = 0; i < 3; ++i)
        facet.corners[i] = now.frame.position + rotate(now.frame.rotation, link.look[t + i]);
      robot_.facets.push_back(std::move(facet));
    }
  }

  /// The joint over the link, which may begin a body of its own.
  void add_joint(const Joint& joint, Placed& now) {
    if (joint.type == JointType::fixed) return;
    const Link& link = from_.links[now.link];
    const std::size_t parent = now.body;
    now.body = new_body(link, now.frame.position, joint.type == JointType::floating);
    if (joint.type == JointType::floating) {
      if (parent != kNone)
        diagnostics_.warning("E0851", joint.place,
                             fmt::format("`{}` is `floating`: nothing holds its child, which only "
                                         "OpenDynamicsEngine can simulate",
                                         joint.name));
      return;
    }
    BodyJoint result;
    result.name = joint_names_.at(joint.name);
    result.slides = joint.type == JointType::prismatic;
    result.parent = body_name(parent);
    result.child = body_name(now.body);
    result.anchor = now.frame.position;
    result.axis = rotate(now.frame.rotation, joint.axis);
    result.limits = joint;
    if (joint.mimic) follow_another(joint, result);
    robot_.joints.push_back(std::move(result));
  }

  /// The joint that a joint follows may follow another one.
  void follow_another(const Joint& joint, BodyJoint& result) {
    const Joint* at = &joint;
    double ratio = 1.0, offset = 0.0;
    for (std::size_t steps = 0; at->mimic && steps <= from_.joints.size(); ++steps) {
      const auto leader = joints_.find(at->mimic->joint);
      if (leader == joints_.end()) {
        error("E0859", at->mimic->place, fmt::format("there is no joint `{}`", at->mimic->joint))
            .help = gen::did_you_mean(at->mimic->joint, names_of_joints());
        return;
      }
      offset += ratio * at->mimic->offset;
      ratio *= at->mimic->ratio;
      at = &from_.joints[leader->second];
    }
    if (at->mimic) {
      error("E0859", joint.mimic->place, fmt::format("`{}` mimics itself", joint.name));
      return;
    }
    if (at->type == JointType::fixed || at->type == JointType::floating) {
      error("E0859", joint.mimic->place,
            fmt::format("`{}` does not turn or slide, so that nothing can mimic it", at->name));
      return;
    }
    result.mimics = joint_names_.at(at->name);
    result.ratio = ratio;
    result.offset = offset;
  }
  std::vector<std::string> names_of_joints() const {
    std::vector<std::string> names;
    for (const Joint& joint : from_.joints) names.push_back(joint.name);
    return names;
  }

  /// A joint that follows another one has no stops and no actuator; where its stops are tighter,
  /// the other one gets them.
  void share_stops() {
    for (BodyJoint& joint : robot_.joints) {
      if (joint.mimics.empty()) continue;
      for (BodyJoint& leader : robot_.joints) {
        if (leader.name != joint.mimics || joint.ratio == 0.0) continue;
        double low = (joint.limits.lower - joint.offset) / joint.ratio;
        double high = (joint.limits.upper - joint.offset) / joint.ratio;
        if (low > high) std::swap(low, high);
        low = std::max(low, leader.limits.lower), high = std::min(high, leader.limits.upper);
        if (low < high) leader.limits.lower = low, leader.limits.upper = high;
      }
      joint.limits.lower = -std::numeric_limits<double>::infinity();
      joint.limits.upper = joint.limits.effort = joint.limits.velocity = -joint.limits.lower;
    }
  }

  void finish_bodies() {
    for (std::size_t b = 0; b < robot_.bodies.size(); ++b) {
      Body& body = robot_.bodies[b];
      const MassAndInertia all = together(parts_[b]);
      body.mass = all.mass;
      body.position = all.mass > 0.0 ? all.centre : places_[b];
      body.inertia = all.inertia;
      body.products = all.products;
    }
    if (robot_.bodies.empty()) add_scenery();
    give_masses(robot_.bodies, diagnostics_);
    for (Body& body : robot_.bodies) check_inertia(body, diagnostics_);
    // Shapes of a body are placed from its centre of mass.
    for (std::size_t g = 0; g < robot_.shapes.size(); ++g) {
      const std::size_t body = bodies_of_shapes_[g];
      if (body != kNone)
        robot_.shapes[g].position = robot_.shapes[g].position - robot_.bodies[body].position;
    }
    for (Facet& facet : robot_.facets) {
      const auto body = std::ranges::find(robot_.bodies, facet.body, &Body::name);
      for (Vector3& corner : facet.corners) {
        if (body != robot_.bodies.end()) corner = corner - body->position;
      }
    }
    check_finite(robot_, from_.place, diagnostics_);
  }

  /// A table, a floor: shapes of the world, and one body that stands for them, as every object has
  /// one.
  void add_scenery() {
    if (robot_.shapes.empty()) {
      error("E0855", from_.place, "nothing of the robot can move, and nothing can be touched");
      return;
    }
    robot_.bodies.push_back(
        {.name = robot_.base, .place = from_.place, .mass = 1.0, .inertia = {{1.0, 1.0, 1.0}}});
    BodyJoint joint;
    joint.name = "to_world";
    joint.is_fixed = true;
    joint.child = robot_.base;
    joint.axis = {{0.0, 0.0, 1.0}};
    robot_.joints.push_back(std::move(joint));
    diagnostics_.note(from_.place, "nothing of it can move: its shapes are part of the world");
  }

  const Description& from_;
  const RobotOptions& options_;
  gen::Diagnostics& diagnostics_;
  Robot robot_;
  std::map<std::string, std::size_t> links_, joints_;
  Names link_names_, joint_names_;
  std::vector<std::vector<std::size_t>> joints_from_;
  std::vector<std::size_t> joint_to_;
  std::vector<std::vector<MassAndInertia>> parts_;
  std::vector<Vector3> places_;  // of the first link of each body
  std::vector<std::size_t> bodies_of_shapes_;
  std::set<std::string> shape_names_;
  std::map<std::string, std::string> names_of_collisions_;  // in the description: here
};

}  // namespace

std::optional<Robot> make_robot(const Description& description, const RobotOptions& options,
                                gen::Diagnostics& diagnostics) {
  return Maker(description, options, diagnostics).make();
}

}  // namespace eagerx::urdf
