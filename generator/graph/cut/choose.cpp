#include "generator/graph/cut/choose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "generator/frontend/parameters/config.hpp"
#include "generator/frontend/spec/named.hpp"
#include "generator/graph/resolve/chosen_nodes.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

/// A name of the command line, which has no place in a file.
Diagnostic& refuse(Diagnostics& diagnostics, const std::string& what) {
  return diagnostics.error("E0397", {}, what);
}

bool is_made(const Graph& whole, std::size_t node) {
  return (whole.task && whole.task->node == node) || (whole.render && whole.render->node == node);
}

/// Names that a user knows: composites and arrays instead of their contents.
std::vector<std::string> known_names(const Graph& whole) {
  std::set<std::string> names;
  for (std::size_t n = 0; n < whole.nodes.size(); ++n) {
    const GraphNode& node = whole.nodes[n];
    if (node.role != NodeRole::node || is_made(whole, n) ||
        (node.entity != nullptr && node.name.starts_with("mux/")))
      continue;
    names.insert(node.name);
    for (std::size_t at = 0; at < node.name.size(); ++at)
      if (node.name[at] == '/' || node.name[at] == '[') names.insert(node.name.substr(0, at));
  }
  return {names.begin(), names.end()};
}

bool is_simulated(const Graph& whole, std::string_view name) {
  return name == "engine" || ranges::any_of(whole.objects, [&](const Object& object) {
           return is_called(object.name, name) != Called::no;
         });
}

void report_not_found(const Graph& whole, const std::string& name, Diagnostics& diagnostics) {
  constexpr const char* kHelp =
      "nodes are cut out, and composites and arrays of them: the rest is what your main loop "
      "brings";
  if (is_simulated(whole, name) || name == "environment" || name == "actions" ||
      name == "observations" || name == kTask || name == kRender) {
    refuse(diagnostics, fmt::format("`{}` cannot be cut out", name)).help = kHelp;
  } else if (name == "agent") {
    refuse(diagnostics, "`agent` cannot be cut out").help =
        "write its policy as a node: `nodes: {NAME: {policy: FILE, …}}`; or leave out `--of`: a "
        "library of the whole graph has `Graph::policy()`";
  } else {
    const auto known = known_names(whole);
    std::vector<std::string> listed = known;
    if (nearest(name, known).empty())
      std::erase_if(listed,
                    [](const auto& n) { return n.find_first_of("/[") != std::string::npos; });
    diagnostics.error("E0307", {}, fmt::format("there is no node `{}`", name)).help =
        suggestion(name, listed, "the graph has no nodes");
  }
}

/// Nodes that gather elements of messages have no name of the user's: where they are between nodes
/// that are cut out, they go with them.
void add_gathering(const Graph& whole, std::vector<bool>& inside) {
  const auto is_gathering = [&](std::size_t n) {
    return whole.nodes[n].role == NodeRole::node && whole.nodes[n].name.starts_with("mux/");
  };
  std::vector<bool> from_inside = inside;
  const auto gathers_from_inside = [&](const GraphNode& node) {
    return ranges::all_of(node.inputs, [&](const Input& i) { return from_inside[i.source_node]; });
  };
  for (bool more = true; more;) {
    more = false;
    for (std::size_t n = 0; n < whole.nodes.size(); ++n) {
      if (from_inside[n] || !is_gathering(n) || !gathers_from_inside(whole.nodes[n])) continue;
      from_inside[n] = more = true;
    }
  }
  for (bool more = true; more;) {
    more = false;
    for (std::size_t n = 0; n < whole.nodes.size(); ++n) {
      for (const Input& input : whole.nodes[n].inputs) {
        if (!inside[n] || inside[input.source_node] || !from_inside[input.source_node]) continue;
        inside[input.source_node] = more = true;
      }
    }
  }
}

void check_resets(const Graph& whole, const std::vector<bool>& inside, Diagnostics& diagnostics) {
  for (std::size_t n = 0; n < whole.nodes.size(); ++n) {
    for (const ResetTarget& target : whole.nodes[n].reset_targets) {
      const bool inner = !target.object && inside[target.node];
      if (!inside[n] && !inner) continue;
      auto& problem = diagnostics.error(
          "E0397", target.span,
          inside[n] ? fmt::format("the reset node `{}` cannot be cut out", whole.nodes[n].name)
                    : fmt::format("`{}` brings about a state of `{}`, which is cut out",
                                  whole.nodes[n].name, whole.nodes[target.node].name));
      problem.help = "a library has no reset routine: its reset sets states";
      return;
    }
  }
}

/// Against the flow, from an input that waits for what is outside, to a node inside.
class PathBack {
 public:
  PathBack(const Graph& whole, const std::vector<bool>& inside) : whole_(whole), inside_(inside) {}

  /// The nodes between, nearest to the input first, and at the end the node inside; empty if there
  /// is none.
  std::vector<std::size_t> from(std::size_t source) {
    std::vector<std::size_t> next(whole_.nodes.size(), kNone), todo = {source};
    next[source] = source;
    while (!todo.empty()) {
      const std::size_t n = todo.back();
      todo.pop_back();
      for (const Input& input : whole_.nodes[n].inputs) {
        if (input.skip || next[input.source_node] != kNone) continue;
        next[input.source_node] = n;
        if (!inside_[input.source_node]) {
          todo.push_back(input.source_node);
          continue;
        }
        std::vector<std::size_t> path = {input.source_node};
        for (std::size_t at = n; at != source; at = next[at]) path.push_back(at);
        path.push_back(source);
        std::ranges::reverse(path);
        return path;
      }
    }
    return {};
  }

 private:
  static constexpr std::size_t kNone = ~std::size_t{0};
  const Graph& whole_;
  const std::vector<bool>& inside_;
};

}  // namespace

std::vector<std::string> spelled_names(const Graph& whole, const std::vector<std::string>& names,
                                       Diagnostics& diagnostics) {
  std::vector<std::string> known = known_names(whole);
  for (const Object& object : whole.objects) known.push_back(object.name);
  std::vector<std::string> result;
  for (const std::string& name : names)
    result.push_back(name == "agent" ? name : node_meant(name, known, {}, diagnostics));
  return result;
}

std::vector<bool> choose_nodes(const Graph& whole, const std::vector<std::string>& names,
                               Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  std::vector<bool> inside(whole.nodes.size());
  for (const std::string& name : names) {
    bool found = false;
    for (std::size_t n = 0; n < whole.nodes.size(); ++n) {
      const GraphNode& node = whole.nodes[n];
      if (node.role != NodeRole::node || is_made(whole, n)) continue;
      if (is_called(node.name, name) == Called::no) continue;
      inside[n] = found = true;
    }
    if (!found) report_not_found(whole, name, diagnostics);
  }
  if (whole.asynchronous)
    refuse(diagnostics, "nothing can be cut out of a graph with `sync: false`").help =
        "a library counts messages, and these nodes take what has arrived: cut them out of a "
        "variant without `sync: false`, such as that of the simulation";
  add_gathering(whole, inside);
  check_resets(whole, inside, diagnostics);
  return diagnostics.error_count() == errors_before ? inside : std::vector<bool>();
}

bool check_order(const Graph& whole, const std::vector<bool>& inside, Diagnostics& diagnostics) {
  PathBack back(whole, inside);
  for (std::size_t n = 0; n < whole.nodes.size(); ++n) {
    if (!inside[n]) continue;
    for (const Input& input : whole.nodes[n].inputs) {
      if (input.skip || inside[input.source_node]) continue;
      const auto path = back.from(input.source_node);
      if (path.empty()) continue;
      const GraphNode& between = whole.nodes[path.front()];
      auto& problem = diagnostics.error(
          "E0398", input.span,
          fmt::format("`{}` waits for what `{}` sends at the same instant, through {}, which is "
                      "outside",
                      input.written, whole.nodes[path.back()].name,
                      between.role == NodeRole::environment ? std::string("the agent")
                                                            : "`" + between.name + "`"));
      problem.help =
          between.role == NodeRole::environment
              ? "one call of step() cannot ask the agent in its middle: add `skip: true` to this "
                "connection, or cut out one side only"
              : fmt::format(
                    "cut `{}` out, too, or add `skip: true` to this connection: one call of "
                    "step() has all its actions before it begins",
                    between.name);
      return false;
    }
  }
  return true;
}

}  // namespace eagerx::gen
