#include "generator/tools/drawing/groups.hpp"

#include <array>
#include <string_view>
#include <utility>

namespace eagerx::gen {
namespace {

using GroupOf = std::map<std::string, std::size_t, std::less<>>;

/// The innermost composite whose name begins `name`.
std::optional<std::size_t> group_around(const GroupOf& groups, std::string_view name) {
  for (std::size_t slash = name.rfind('/'); slash != std::string_view::npos && slash > 0;
       slash = name.rfind('/', slash - 1)) {
    const auto found = groups.find(name.substr(0, slash));
    if (found != groups.end()) return found->second;
  }
  return std::nullopt;
}

/// Nodes that compose/ adds are called `mux/` and the port that they send to, whose owner has them
/// next to it.
std::optional<std::size_t> group_of(const GroupOf& groups, std::string_view name) {
  constexpr std::string_view kAdded = "mux/";
  if (!name.starts_with(kAdded)) return group_around(groups, name);
  name.remove_prefix(kAdded.size());
  const std::size_t part = name.find("/part[");
  if (part != std::string_view::npos) name = name.substr(0, part);
  return group_around(groups, name.substr(0, name.rfind('/')));
}

BoxGroup group_of(const CompositeSpec& composite) {
  BoxGroup group;
  group.box.kind = composite.is_object ? BoxKind::object : BoxKind::node;
  group.box.name = composite.name;
  group.box.subtitle =
      composite.type +
      (composite.rate_hz ? ", " + composite.rate_hz->to_string() + " Hz" : std::string());
  group.box.about = composite.about;
  const auto add = [](const auto& named, std::vector<BoxPort>& ports,
                      std::map<std::string, std::size_t>& number_of) {
    for (const auto& [name, inside] : named) {
      for (const auto& port : inside) number_of.emplace(port, ports.size());
      ports.push_back({name, ""});
    }
  };
  add(composite.inputs, group.box.inputs, group.inputs);
  add(composite.outputs, group.box.outputs, group.outputs);
  return group;
}

/// `name` as it is called in its group.
void shorten(Box& box, const std::vector<BoxGroup>& groups, std::optional<std::size_t> around) {
  box.full_name = box.name;
  if (!around) return;
  const std::string prefix = groups[*around].box.full_name + "/";
  if (box.name.starts_with(prefix)) box.name.erase(0, prefix.size());
}

/// Puts boxes into groups, and wires into and out of them.
class Nester {
 public:
  explicit Nester(const Drawing& flat) : flat_(flat), groups_(flat.groups) {
    drawings_.resize(groups_.size() + 1);
    of_group_.resize(groups_.size());
    is_placed_.resize(groups_.size(), false);
  }

  Drawing nest() {
    drawings_[kOutermost].title = flat_.title;
    for (std::size_t g = 0; g < groups_.size(); ++g)
      for (const BoxKind kind : {BoxKind::entry, BoxKind::exit}) {
        Box end;
        end.kind = kind;
        drawings_[g + 1].boxes.push_back(std::move(end));
      }
    for (const Box& box : flat_.boxes) {
      const std::size_t scope = scope_of(box.group);
      place_group(box.group);
      of_box_.push_back(drawings_[scope].boxes.size());
      drawings_[scope].boxes.push_back(box);
    }
    for (const Wire& wire : flat_.wires) add(wire);
    for (auto& drawing : drawings_)
      for (auto& wire : drawing.wires)
        if (wire.readers.size() > 1)
          wire.about += " and " + std::to_string(wire.readers.size() - 1) + " more";
    return finished(kOutermost);
  }

 private:
  static constexpr std::size_t kOutermost = 0, kEntry = 0, kExit = 1;

  struct End {
    std::size_t scope = 0, box = 0, port = 0;
  };

  static std::size_t scope_of(std::optional<std::size_t> group) {
    return group ? *group + 1 : kOutermost;
  }

  /// Where its first box stands.
  void place_group(std::optional<std::size_t> group) {
    if (!group || is_placed_[*group]) return;
    is_placed_[*group] = true;
    place_group(groups_[*group].around);
    Drawing& outer = drawings_[scope_of(groups_[*group].around)];
    of_group_[*group] = outer.boxes.size();
    outer.boxes.push_back(groups_[*group].box);
  }

  /// The groups around a box, from inside.
  std::vector<std::size_t> around(std::optional<std::size_t> group) const {
    std::vector<std::size_t> result;
    for (; group; group = groups_[*group].around) result.push_back(*group);
    return result;
  }

  /// The port of a group that a wire passes: what the composite binds, or one that is made.
  std::size_t port(std::size_t g, bool leaves, const std::string& inside) {
    BoxGroup& group = groups_[g];
    auto& ports = leaves ? group.box.outputs : group.box.inputs;
    const auto [found, is_new] =
        (leaves ? group.outputs : group.inputs).emplace(inside, ports.size());
    if (is_new) {
      const std::string prefix = group.box.full_name + "/";
      ports.push_back(
          {inside.starts_with(prefix) ? inside.substr(prefix.size()) : inside, std::string()});
    }
    return found->second;
  }

  void add(const Wire& wire) {
    const Box &from = flat_.boxes[wire.from], &to = flat_.boxes[wire.to];
    auto out = around(from.group), in = around(to.group);
    while (!out.empty() && !in.empty() && out.back() == in.back()) {
      out.pop_back();
      in.pop_back();
    }
    const std::string sent = from.full_name + "." + from.outputs[wire.output].name;
    const std::string received = to.full_name + "." + to.inputs[wire.input].name;
    End at{scope_of(from.group), of_box_[wire.from], wire.output};
    for (const std::size_t g : out) {
      const std::size_t p = port(g, true, sent);
      add(wire, at, {g + 1, kExit, p});
      at = {scope_of(groups_[g].around), of_group_[g], p};
    }
    for (auto g = in.rbegin(); g != in.rend(); ++g) {
      const std::size_t p = port(*g, false, received);
      add(wire, at, {at.scope, of_group_[*g], p});
      at = {*g + 1, kEntry, p};
    }
    add(wire, at, {at.scope, of_box_[wire.to], wire.input});
  }

  void add(const Wire& wire, const End& from, const End& to) {
    auto& wires = drawings_[from.scope].wires;
    const std::array<std::size_t, 5> ends = {from.scope, from.box, from.port, to.box, to.port};
    const auto [known, is_new] = known_.emplace(ends, wires.size());
    if (is_new)
      wires.push_back({from.box, from.port, to.box, to.port, wire.about, wire.sets_state, {}});
    auto& readers = wires[known->second].readers;
    readers.insert(readers.end(), wire.readers.begin(), wire.readers.end());
  }

  Drawing finished(std::size_t scope) {
    Drawing drawing = std::move(drawings_[scope]);
    if (scope != kOutermost) {
      drawing.boxes[kEntry].outputs = groups_[scope - 1].box.inputs;
      drawing.boxes[kExit].inputs = groups_[scope - 1].box.outputs;
    }
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      if (!is_placed_[g] || scope_of(groups_[g].around) != scope) continue;
      Box& box = drawing.boxes[of_group_[g]];
      box.inputs = groups_[g].box.inputs;
      box.outputs = groups_[g].box.outputs;
      box.inside = std::make_shared<const Drawing>(finished(g + 1));
    }
    return drawing;
  }

  const Drawing& flat_;
  std::vector<BoxGroup> groups_;
  std::vector<Drawing> drawings_;      // the outermost, then of each group
  std::vector<std::size_t> of_box_;    // of each flat box, its number where it is
  std::vector<std::size_t> of_group_;  // of each group, the same
  std::vector<bool> is_placed_;        // groups with boxes in them
  std::map<std::array<std::size_t, 5>, std::size_t> known_;  // wires, by their ends
};

}  // namespace

void add_groups(const std::vector<CompositeSpec>& composites, Drawing& drawing) {
  GroupOf number_of;
  for (const CompositeSpec& composite : composites) {
    number_of.emplace(composite.name, drawing.groups.size());
    drawing.groups.push_back(group_of(composite));
    drawing.groups.back().box.full_name = composite.name;
  }
  for (BoxGroup& group : drawing.groups) {
    group.around = group_around(number_of, group.box.full_name);
    shorten(group.box, drawing.groups, group.around);
  }
  for (Box& box : drawing.boxes) {
    box.group = group_of(number_of, box.name);
    shorten(box, drawing.groups, box.group);
  }
}

Drawing nested(const Drawing& flat) {
  return flat.groups.empty() ? flat : Nester(flat).nest();
}

}  // namespace eagerx::gen
