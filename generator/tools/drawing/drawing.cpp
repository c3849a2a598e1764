#include "generator/tools/drawing/drawing.hpp"

#include <fmt/format.h>

#include <optional>
#include <set>
#include <tuple>

#include "generator/support/diagnostics/search.hpp"
#include "generator/tools/drawing/groups.hpp"

namespace eagerx::gen {
namespace {

void append_item(std::string& list, const std::string& item) {
  list += (list.empty() ? "" : ", ") + item;
}

std::string via(const std::optional<Processor>& processor) {
  return "through " + processor->names();
}

std::string detail_of(const Input& input) {
  std::string text;
  if (input.processor) append_item(text, via(input.processor));
  if (input.window != 1) append_item(text, fmt::format("window {}", input.window));
  if (input.random_delay && input.max_delay_s)
    append_item(text, fmt::format("random delay, up to {} s", input.max_delay_s->to_string()));
  else if (input.max_delay_s)
    append_item(text, fmt::format("delay up to {} s", input.max_delay_s->to_string()));
  else if (!(input.delay_s == Rational()))
    append_item(text, fmt::format("delay {} s", input.delay_s.to_string()));
  if (input.skip) append_item(text, "skip");
  return text;
}

std::string agent_of(const Agent& agent) {
  if (agent.kind == AgentSpec::Kind::zero) return "agent: zero";
  if (agent.kind == AgentSpec::Kind::random) return "agent: random";
  return "agent: " + agent.file;
}

/// Builds the boxes of one view, and remembers what stands for what.
class Builder {
 public:
  Builder(const Graph& graph, const std::vector<CompositeSpec>& composites, GraphView view)
      : graph_(graph), composites_(composites), view_(view) {}

  Drawing build() {
    drawing_.title = graph_.name;
    box_of_node_.resize(graph_.nodes.size());
    box_of_object_.resize(graph_.objects.size());
    add_box(BoxKind::actions, "actions", agent_of(graph_.agent));
    for (std::size_t n = 0; n < graph_.nodes.size(); ++n) add_node(n);
    if (view_ == GraphView::user) add_objects();
    observations_ = add_box(BoxKind::observations, "observations",
                            graph_.environment().rate_hz.to_string() + " Hz");
    for (const std::size_t end : {kActions, observations_})
      drawing_.boxes[end].node = Graph::kEnvironment;
    for (std::size_t n = 0; n < graph_.nodes.size(); ++n) add_wires(n);
    for (const std::size_t end : {observations_, kActions}) drop_without_ports(end);
    if (!composites_.empty()) add_groups(composites_, drawing_);
    return std::move(drawing_);
  }

 private:
  /// Of a graph without actions: a box that nothing leads to would only take room. Its number is
  /// that of the next box then.
  void drop_without_ports(std::size_t end) {
    const Box& box = drawing_.boxes[end];
    if (!box.inputs.empty() || !box.outputs.empty()) return;
    drawing_.boxes.erase(drawing_.boxes.begin() + static_cast<std::ptrdiff_t>(end));
    for (Wire& wire : drawing_.wires) {
      if (wire.from > end) --wire.from;
      if (wire.to > end) --wire.to;
    }
  }

  std::size_t add_box(BoxKind kind, std::string name, std::string subtitle,
                      std::string about = {}) {
    drawing_.boxes.push_back(
        {kind, std::move(name), std::move(subtitle), std::move(about), {}, {}});
    return drawing_.boxes.size() - 1;
  }

  /// Inside an object, where the user's view does not look.
  bool is_hidden(const GraphNode& node) const {
    return view_ == GraphView::user && (node.object.has_value() || node.role == NodeRole::engine ||
                                        node.role == NodeRole::engine_node);
  }

  BoxKind kind_of(std::size_t n) const {
    const GraphNode& node = graph_.nodes[n];
    if (graph_.task && graph_.task->node == n) return BoxKind::task;
    if (node.role == NodeRole::engine) return BoxKind::engine;
    if (node.role == NodeRole::engine_node) return BoxKind::engine_node;
    return node.is_reset_node() ? BoxKind::reset_node : BoxKind::node;
  }

  void add_node(std::size_t n) {
    const GraphNode& node = graph_.nodes[n];
    if (n == Graph::kEnvironment || is_hidden(node)) return;
    const std::string rate = node.rate_hz.to_string() + " Hz";
    const BoxKind kind = kind_of(n);
    const bool has_type = node.entity != nullptr && kind != BoxKind::task;
    box_of_node_[n] =
        add_box(kind, node.name, has_type ? node.entity->id.value + ", " + rate : rate,
                has_type ? node.entity->summary : std::string());
    Box& box = drawing_.boxes[*box_of_node_[n]];
    box.node = n;
    for (const Input& input : node.inputs) port(box.inputs, input.name, detail_of(input));
    for (const Output& output : node.outputs)
      port(box.outputs, output.name, output.processor ? via(output.processor) : std::string());
  }

  void add_objects() {
    for (std::size_t o = 0; o < graph_.objects.size(); ++o) {
      const Object& object = graph_.objects[o];
      std::string subtitle = object.entity->id.value;
      if (object.implementation != nullptr)
        subtitle += " on " + object.implementation->engine.value;
      box_of_object_[o] = add_box(BoxKind::object, object.name, subtitle, object.entity->summary);
      drawing_.boxes[*box_of_object_[o]].object = o;
    }
  }

  /// Its number among the ports of the box; a new one if it is not there yet.
  static std::size_t port(std::vector<BoxPort>& ports, const std::string& name,
                          const std::string& detail = {}) {
    const auto found = ranges::find(ports, name, &BoxPort::name);
    if (found != ports.end()) return static_cast<std::size_t>(found - ports.begin());
    ports.push_back({name, detail});
    return ports.size() - 1;
  }

  /// The box that sends what `input` receives, and its port; none if the view hides it.
  bool find_source(const Input& input, Wire& wire) {
    const GraphNode& node = graph_.nodes[input.source_node];
    const Output& output = node.outputs[input.source_output];
    std::string name = output.name;
    if (input.source_node == Graph::kEnvironment) {
      wire.from = kActions;
    } else if (!is_hidden(node)) {
      wire.from = *box_of_node_[input.source_node];
    } else if (node.object && !input.sensor.empty()) {
      wire.from = *box_of_object_[*node.object];
      name = input.sensor.substr(input.sensor.find('.') + 1);
    } else {
      return false;
    }
    const std::string detail = output.processor ? via(output.processor) : std::string();
    wire.output = port(drawing_.boxes[wire.from].outputs, name, detail);
    return true;
  }

  bool find_reader(std::size_t n, const Input& input, Wire& wire) {
    const GraphNode& node = graph_.nodes[n];
    std::string name = input.name;
    if (n == Graph::kEnvironment) {
      wire.to = observations_;
    } else if (!is_hidden(node)) {
      wire.to = *box_of_node_[n];
    } else if (node.object && input.actuator) {
      wire.to = *box_of_object_[*node.object];
      name = input.written.substr(input.written.find('.') + 1);
    } else {
      return false;
    }
    wire.input = port(drawing_.boxes[wire.to].inputs, name, detail_of(input));
    return true;
  }

  void add(Wire wire) {
    const auto ends = [](const Wire& w) { return std::tuple(w.from, w.output, w.to, w.input); };
    if (known_.insert(ends(wire)).second) drawing_.wires.push_back(std::move(wire));
  }

  void add_wires(std::size_t n) {
    for (std::size_t i = 0; i < graph_.nodes[n].inputs.size(); ++i) {
      const Input& input = graph_.nodes[n].inputs[i];
      Wire wire;
      const bool inner = view_ == GraphView::user && is_hidden(graph_.nodes[n]) && !input.actuator;
      if (inner || !find_source(input, wire) || !find_reader(n, input, wire)) continue;
      wire.about = fmt::format("{} to {}: {}", name_of_source(graph_, input), input.written,
                               input.space.describe());
      wire.readers = {{n, i}};
      add(std::move(wire));
    }
    for (const ResetTarget& target : graph_.nodes[n].reset_targets) add_reset(n, target);
  }

  void add_reset(std::size_t n, const ResetTarget& target) {
    const std::optional<std::size_t> owner =
        target.object ? box_of_object_[*target.object] : box_of_node_[target.node];
    if (!owner || !box_of_node_[n]) return;  // an object's states, where its nodes are shown
    const std::vector<State>& states =
        target.object ? graph_.objects[*target.object].states : graph_.nodes[target.node].states;
    Wire wire;
    wire.sets_state = true;
    wire.from = *box_of_node_[n];
    wire.output = port(drawing_.boxes[wire.from].outputs, target.name);
    wire.to = *owner;
    wire.input = port(drawing_.boxes[wire.to].inputs, states[target.state].name, "state");
    wire.about = fmt::format("{}.{} brings about the state {}.{} at a reset", graph_.nodes[n].name,
                             target.name, drawing_.boxes[wire.to].name, states[target.state].name);
    add(std::move(wire));
  }

  static constexpr std::size_t kActions = 0;
  const Graph& graph_;
  const std::vector<CompositeSpec>& composites_;
  GraphView view_;
  Drawing drawing_;
  std::size_t observations_ = 0;
  std::vector<std::optional<std::size_t>> box_of_node_, box_of_object_;
  std::set<std::tuple<std::size_t, std::size_t, std::size_t, std::size_t>> known_;
};

}  // namespace

Drawing drawing_of(const Graph& graph, const std::vector<CompositeSpec>& composites,
                   GraphView view) {
  return Builder(graph, composites, view).build();
}

}  // namespace eagerx::gen
