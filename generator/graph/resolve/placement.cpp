#include "generator/graph/resolve/placement.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <set>

#include "generator/graph/resolve/chosen_nodes.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

constexpr std::string_view kController = "controller";
constexpr std::string_view kAgent = "agent";

class Placer {
 public:
  explicit Placer(UnresolvedGraph& draft) : draft_(draft), spans_(draft.nodes.size()) {
    placement_.part_of.assign(draft.nodes.size(), Placement::kHub);
  }

  void run(const std::vector<PlacementSpec>& items) {
    std::vector<std::optional<std::size_t>> parts;
    parts.reserve(items.size());
    for (const auto& item : items) parts.push_back(part_of(item));
    // Nodes that are placed by name do not go with the rest.
    for (std::size_t i = 0; i < items.size(); ++i)
      if (parts[i] && !is_rest(items[i])) place(items[i], *parts[i]);
    for (std::size_t i = 0; i < items.size(); ++i)
      if (parts[i] && is_rest(items[i])) place_rest(items[i], *parts[i]);
    if (placement_.parts.empty()) return;
    name_the_only_part(items);
    check_agent();
    draft_.graph.placement = std::move(placement_);
  }

 private:
  /// The part of an item, which is new if none before it is the same. Nothing after a problem.
  std::optional<std::size_t> part_of(const PlacementSpec& item) {
    const Target* const target = find_target(item.target);
    if (target == nullptr) return std::nullopt;
    const Spanned<std::string>& named = !item.part.value.empty()   ? item.part
                                        : !item.host.value.empty() ? item.host
                                                                   : item.target;
    auto& parts = placement_.parts;
    const auto found = ranges::find(parts, named.value, &PlacedPart::name);
    if (found == parts.end()) {
      if (!check_new(item, *target, named)) return std::nullopt;
      parts.push_back({named.value, target, item.host.value, item.name.span, path_of_key(item)});
      return parts.size() - 1;
    }
    if (!item.key.value.empty() && !found->key.empty() && found->key != path_of_key(item)) {
      refuse(item.key.span, fmt::format("part `{}` has two keys", named.value), found->span,
             "a part has one line, and the line one key");
      return std::nullopt;
    }
    if (found->key.empty()) found->key = path_of_key(item);
    if (found->target != target || found->host != item.host.value) {
      refuse(item.target.span,
             found->target != target
                 ? fmt::format("part `{}` is on two targets, `{}` and `{}`", named.value,
                               found->target->id.value, target->id.value)
                 : fmt::format("part `{}` is on two machines, {} and {}", named.value,
                               machine(found->host), machine(item.host.value)),
             found->span);
      return std::nullopt;
    }
    return static_cast<std::size_t>(found - parts.begin());
  }

  [[nodiscard]] std::string path_of_key(const PlacementSpec& item) const {
    if (item.key.value.empty()) return {};
    return (std::filesystem::path(draft_.spec.path).parent_path() / item.key.value).string();
  }

  static std::string machine(const std::string& host) {
    return host.empty() ? "this one" : "`" + host + "`";
  }

  void refuse(Span span, const std::string& what, Span first,
              const char* help =
                  "a part is one program on one target: give the other "
                  "its own name, such as `{part: left, target: stm32f405}`") {
    auto& problem = draft_.diagnostics.error("E0333", span, what);
    problem.notes.push_back({"first here", first, ""});
    problem.help = help;
  }

  bool check_new(const PlacementSpec& item, const Target& target,
                 const Spanned<std::string>& named) {
    if (named.value == "host") {
      draft_.diagnostics.error("E0333", named.span, "a part cannot be called `host`").help =
          "that is the program of all that is not placed: give the part another name";
      return false;
    }
    if (item.host.value.empty() && !item.key.value.empty()) {
      draft_.diagnostics
          .error("E0332", item.key.span,
                 fmt::format("part `{}` has no `host`, so its line needs no key", named.value))
          .help = "leave out `key`, or say on which machine the part runs: `host`";
      return false;
    }
    if (item.host.value.empty() || !target.system.empty()) return true;
    draft_.diagnostics
        .error("E0332", item.host.span,
               fmt::format("`{}` is not a program of a machine: it has a line to the hub",
                           target.id.value))
        .help = "leave out `host`, and name the line with `--link` of the program";
    return false;
  }

  const Target* find_target(const Spanned<std::string>& wanted) {
    const Target* const found = draft_.library.find_target(wanted.value);
    if (found == nullptr) {
      draft_.diagnostics
          .error("E0316", wanted.span, fmt::format("unknown target `{}`", wanted.value))
          .help = suggestion(wanted.value, partners(), "no target can run a part of a graph");
      return nullptr;
    }
    if (!found->partner.empty()) return found;
    draft_.diagnostics
        .error("E0334", wanted.span,
               fmt::format("target `{}` cannot run a part of a graph", wanted.value))
        .help = fmt::format("its manifest has no `partner`; these targets have one: {}",
                            join(partners(), ", "));
    return nullptr;
  }

  /// The targets that can run a part of a graph.
  [[nodiscard]] std::vector<std::string> partners() const {
    std::vector<std::string> ids;
    for (const auto& [id, target] : draft_.library.all_targets()) {
      if (!target.partner.empty()) ids.push_back(id);
    }
    return ids;
  }

  /// Whether nodes can be placed at all: not the graph's own, of a task or of pictures.
  [[nodiscard]] bool is_placeable(std::size_t n) const {
    return draft_.nodes[n].node.role == NodeRole::node && !draft_.is_added(n);
  }
  [[nodiscard]] bool is_name_of_node(std::string_view name) const {
    for (std::size_t n = 0; n < draft_.nodes.size(); ++n)
      if (is_placeable(n) && is_called(owner_of(draft_.nodes[n].node.name), name) != Called::no)
        return true;
    return false;
  }
  /// Nodes, composites and arrays.
  [[nodiscard]] std::set<std::string> known_names() const {
    std::set<std::string> known;
    for (std::size_t n = 0; n < draft_.nodes.size(); ++n) {
      if (!is_placeable(n)) continue;
      const std::string& name = draft_.nodes[n].node.name;
      known.insert(name);
      known.insert(name.substr(0, name.find_first_of("/[")));
    }
    return known;
  }
  /// As nodes are spelled.
  [[nodiscard]] std::string name_of(const PlacementSpec& item) const {
    if (item.name.value == kAgent || item.name.value == kController) return item.name.value;
    std::vector<std::string> known;
    for (const std::string& name : known_names()) known.push_back(name);
    for (const UnresolvedObject& object : draft_.objects) known.push_back(object.name);
    return node_meant(item.name.value, known, item.name.span, draft_.diagnostics);
  }
  /// `controller`, where no node is called so.
  [[nodiscard]] bool is_rest(const PlacementSpec& item) const {
    return item.name.value == kController && !is_name_of_node(kController);
  }

  void place(const PlacementSpec& item, std::size_t part) {
    const std::string name = name_of(item);
    bool found = false;
    for (std::size_t n = 0; n < draft_.nodes.size(); ++n) {
      if (!is_placeable(n) || is_called(owner_of(draft_.nodes[n].node.name), name) == Called::no)
        continue;
      put(n, part, item);
      found = true;
    }
    // A node that is called so comes before the word.
    if (found) return;
    if (name == kAgent) {
      put(Graph::kEnvironment, part, item);
      return;
    }
    const bool simulated = name == "engine" || draft_.find_object(name) != nullptr;
    if (simulated) {
      draft_.diagnostics
          .error("E0332", item.name.span, fmt::format("`{}` cannot be placed on a board", name))
          .help = "the engine and its objects stay on Linux: place nodes, `agent` or `controller`";
      return;
    }
    std::vector<std::string> known = {"controller", "agent"};
    for (const std::string& node : known_names()) known.push_back(node);
    draft_.diagnostics.error("E0307", item.name.span, fmt::format("there is no node `{}`", name))
        .help = suggestion(name, known, "");
  }

  void put(std::size_t node, std::size_t part, const PlacementSpec& item) {
    std::size_t& place = placement_.part_of[node];
    if (place != Placement::kHub && place != part) {
      const bool is_agent = node == Graph::kEnvironment;
      refuse(item.name.span,
             fmt::format("`{}` is in two parts, `{}` and `{}`",
                         is_agent ? std::string(kAgent) : draft_.nodes[node].node.name,
                         placement_.parts[place].name, placement_.parts[part].name),
             spans_[node]);
      return;
    }
    place = part;
    spans_[node] = item.name.span;
  }

  void place_rest(const PlacementSpec& item, std::size_t part) {
    const auto take = [&](std::size_t node) {
      if (placement_.part_of[node] == Placement::kHub) put(node, part, item);
    };
    take(Graph::kEnvironment);
    for (std::size_t n = 0; n < draft_.nodes.size(); ++n)
      if (is_placeable(n)) take(n);
  }

  /// `board`, if the graph gives it no name.
  void name_the_only_part(const std::vector<PlacementSpec>& items) {
    const bool is_named = ranges::any_of(items, [](const PlacementSpec& item) {
      return !item.part.value.empty() || !item.host.value.empty();
    });
    if (placement_.parts.size() == 1 && !is_named) placement_.parts.front().name = "board";
  }

  void check_agent() {
    const std::size_t part = placement_.part_of[Graph::kEnvironment];
    if (part == Placement::kHub || draft_.graph.agent.kind != AgentSpec::Kind::csv) return;
    draft_.diagnostics
        .error("E0332", placement_.parts[part].span,
               "the agent reads a file, and a board has no files")
        .help = "place only nodes, not `agent` or `controller`";
  }

  /// `leg[2]/…` for `mux/leg[2]/…`, which compose/ adds for an input of it and goes along.
  static std::string_view owner_of(std::string_view node) {
    constexpr std::string_view kAdded = "mux/";
    if (node.starts_with(kAdded)) node.remove_prefix(kAdded.size());
    return node;
  }

  UnresolvedGraph& draft_;
  Placement placement_;
  std::vector<Span> spans_;  // by node: what has placed it
};

}  // namespace

void place_parts(UnresolvedGraph& draft, const std::vector<PlacementSpec>& placement) {
  if (!placement.empty()) Placer(draft).run(placement);
}

}  // namespace eagerx::gen
