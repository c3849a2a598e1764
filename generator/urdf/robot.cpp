#include "generator/urdf/robot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "generator/backend/emit/namer.hpp"
#include "generator/frontend/spec/format.hpp"
#include "generator/urdf/inertia.hpp"

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

/// `inner` is given in `outer`.
Frame operator*(const Frame& outer, const Frame& inner) {
  return {outer.position + rotate(outer.rotation, inner.position),
          models::normalised(product(outer.rotation, inner.rotation))};
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
    finish_bodies();
    if (diagnostics_.error_count() > before) return std::nullopt;
    robot_.ground = options_.ground;
    return std::move(robot_);
  }

 private:
  gen::Diagnostic& error(const char* code, gen::Span place, std::string message) {
    return diagnostics_.error(code, place, std::move(message));
  }

  /// Names as they are in generated code, each only once.
  template <class Items>
  void index(const Items& items, const char* kind, std::map<std::string, std::size_t>& result) {
    std::map<std::string, std::size_t> generated;
    for (std::size_t i = 0; i < items.size(); ++i) {
      result.emplace(items[i].name, i);
      const auto [other, is_new] = generated.emplace(identifier(items[i].name), i);
      if (is_new) continue;
      auto& twice = error("E0854", items[i].place,
                          fmt::format("there is another {} `{}`", kind, items[other->second].name));
      twice.notes.push_back({"the first one", items[other->second].place, ""});
      if (items[other->second].name != items[i].name)
        twice.help = fmt::format("both would be called `{}`", other->first);
    }
  }

  void index_links() {
    index(from_.links, "link", links_);
    std::map<std::string, std::size_t> joints;
    index(from_.joints, "joint", joints);
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
    robot_.id = options_.id.empty() ? gen::camel(identifier(from_.name)) : options_.id;
    if (robot_.id.empty() || (robot_.id[0] >= '0' && robot_.id[0] <= '9') || robot_.id == "Io")
      robot_.id.insert(0, "Robot");
    robot_.name = gen::snake(identifier(from_.name));
    if (robot_.name.empty()) robot_.name = "robot";
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
    robot_.base = identifier(first.name);
    const bool is_fixed =
        options_.base == Base::fixed || (options_.base == Base::by_inertia && !first.inertial);
    std::vector<Placed> open = {{root, {}, is_fixed ? kNone : new_body(first, true)}};
    while (!open.empty()) {
      Placed now = open.back();
      open.pop_back();
      add_link(now);
      const auto& joints = joints_from_[now.link];
      for (std::size_t i = joints.size(); i-- > 0;)
        open.push_back(follow(now, from_.joints[joints[i]]));
    }
  }

  std::size_t new_body(const Link& link, bool is_free) {
    robot_.bodies.push_back({.name = identifier(link.name), .place = link.place});
    robot_.bodies.back().is_free = is_free;
    parts_.emplace_back();
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
      if (name.empty()) name = identifier(link.name) + (count > 1 ? fmt::format("_{}", count) : "");
      if (!shape_names_.insert(name).second)
        error("E0854", collision.place, fmt::format("there is another collision `{}`", name));
      robot_.shapes.push_back({std::move(name), collision.kind, body_name(now.body), collision.size,
                               frame.position, frame.rotation});
      bodies_of_shapes_.push_back(now.body);
    }
  }

  /// The joint over the link, which may begin a body of its own.
  void add_joint(const Joint& joint, Placed& now) {
    if (joint.type == JointType::fixed) return;
    const Link& link = from_.links[now.link];
    const std::size_t parent = now.body;
    now.body = new_body(link, joint.type == JointType::floating);
    if (joint.type == JointType::floating) {
      if (parent != kNone)
        error("E0851", joint.place, "only joints with the world can be `floating`").help =
            "without a joint a body cannot know of another one";
      return;
    }
    BodyJoint result;
    result.name = identifier(joint.name);
    result.slides = joint.type == JointType::prismatic;
    result.parent = body_name(parent);
    result.child = body_name(now.body);
    result.anchor = now.frame.position;
    result.axis = rotate(now.frame.rotation, joint.axis);
    result.limits = joint;
    robot_.joints.push_back(std::move(result));
  }

  void finish_bodies() {
    for (std::size_t b = 0; b < robot_.bodies.size(); ++b) {
      Body& body = robot_.bodies[b];
      const MassAndInertia all = together(parts_[b]);
      body.mass = all.mass;
      body.position = all.centre;
      body.inertia = all.inertia;
      body.products = all.products;
      check(body);
    }
    if (robot_.bodies.empty()) error("E0855", from_.place, "nothing of the robot can move");
    // Shapes of a body are placed from its centre of mass.
    for (std::size_t g = 0; g < robot_.shapes.size(); ++g) {
      const std::size_t body = bodies_of_shapes_[g];
      if (body != kNone)
        robot_.shapes[g].position = robot_.shapes[g].position - robot_.bodies[body].position;
    }
  }

  void check(const Body& body) {
    if (!(body.mass > 0.0)) {
      error("E0856", body.place, fmt::format("`{}` can move, but has no mass", body.name)).help =
          "give the link an `inertial`, or make its joint `fixed`";
    } else if (!is_positive(body.inertia, body.products)) {
      error("E0856", body.place,
            fmt::format("no body has the inertia of `{}`: it is not positive definite", body.name))
          .help = "its principal moments are larger than 0; check the signs of ixy, ixz, iyz";
    } else if (!is_of_a_body(body.inertia, body.products)) {
      diagnostics_.warning(
          "E0856", body.place,
          fmt::format("no body has the inertia of `{}`: one moment is larger than both others",
                      body.name));
    }
  }

  const Description& from_;
  const RobotOptions& options_;
  gen::Diagnostics& diagnostics_;
  Robot robot_;
  std::map<std::string, std::size_t> links_;
  std::vector<std::vector<std::size_t>> joints_from_;
  std::vector<std::size_t> joint_to_;
  std::vector<std::vector<MassAndInertia>> parts_;
  std::vector<std::size_t> bodies_of_shapes_;
  std::set<std::string> shape_names_;
};

}  // namespace

std::optional<Robot> make_robot(const Description& description, const RobotOptions& options,
                                gen::Diagnostics& diagnostics) {
  return Maker(description, options, diagnostics).make();
}

}  // namespace eagerx::urdf
