#include "generator/graph/cut/cut.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "generator/frontend/spec/named.hpp"
#include "generator/graph/cut/choose.hpp"
#include "generator/graph/cut/ports.hpp"
#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

constexpr std::size_t kOutside = ~std::size_t{0};

/// "robot_controller"; of several names "robot_cut".
std::string name_of(const Graph& whole, const std::vector<std::string>& names) {
  std::string suffix;
  for (const char c : names.size() == 1 ? names.front() : std::string("cut")) {
    if (c == '/' || c == '[')
      suffix += '_';
    else if (c != ']' && c != '*')
      suffix += c;
  }
  return whole.name + "_" + suffix;
}

class Cutter {
 public:
  Cutter(const Graph& whole, const CutRequest& request, const std::vector<bool>& inside,
         Diagnostics& diagnostics)
      : whole_(whole),
        request_(request),
        inside_(inside),
        crossings_(crossings_of(whole, inside, request)),
        diagnostics_(diagnostics) {}

  std::optional<Graph> run() {
    if (crossings_.out.empty()) {
      diagnostics_
          .error("E0399", {},
                 fmt::format("nothing outside takes what {}",
                             request_.names.size() == 1 ? "`" + request_.names.front() + "` sends"
                                                        : "these nodes send"))
          .help = "a library has outputs: name the nodes that send to the plant, too";
      return std::nullopt;
    }
    take_graph();
    add_environment();
    add_actions();
    add_nodes();
    add_observations();
    add_safety();
    find_applied_spaces(graph_);
    return std::move(graph_);
  }

 private:
  void take_graph() {
    graph_.name = name_of(whole_, request_.names);
    graph_.path = whole_.path;
    graph_.file_name = whole_.file_name;
    graph_.double_precision = whole_.double_precision;
    graph_.reset_timeout_s = whole_.reset_timeout_s;
    graph_.include_roots = whole_.include_roots;
    graph_.span = whole_.span;
    graph_.agent.span = whole_.agent.span;
    graph_.cut.emplace();
  }

  /// How often the main loop has to call: the longest time that all ticks of ports are multiples
  /// of.
  void add_environment() {
    std::set<std::string> rates;
    Rational rate;
    const auto add = [&](const Crossing& crossing) {
      const Rational& of_port = crossing.port.rate_hz;
      rate = rate == Rational() ? of_port : lcm(rate, of_port);
      rates.insert(of_port.to_string());
    };
    std::ranges::for_each(crossings_.in, add);
    std::ranges::for_each(crossings_.out, add);
    if (!rates.contains(rate.to_string())) {
      auto& problem = diagnostics_.warning(
          "W0117", whole_.span,
          fmt::format("step() has to be called {} times a second, and no port has this rate",
                      rate.to_string()));
      problem.label = fmt::format("the ports have {} Hz", join(rates, " and "));
      problem.help = "choose rates of which the fastest is a multiple of the others";
    }
    GraphNode environment;
    environment.name = "environment";
    environment.role = NodeRole::environment;
    environment.rate_hz = rate;
    environment.span = whole_.environment().span;
    graph_.nodes.push_back(std::move(environment));
  }

  void add_actions() {
    for (const Crossing& crossing : crossings_.in) {
      const Output& sent = output_of(crossing);
      Output action;
      action.name = crossing.port.name;
      action.raw = action.space = sent.space;
      action.span = crossing.span;
      const std::size_t place = graph_.nodes[Graph::kEnvironment].outputs.size();
      graph_.nodes[Graph::kEnvironment].outputs.push_back(std::move(action));
      graph_.cut->actions.push_back(crossing.port);
      senders_.emplace_back(Graph::kEnvironment, place);
      if (crossing.port.rate_hz != graph_.environment().rate_hz) add_port(crossing, place);
    }
  }

  /// A port that takes an action at the rate of its sender, so that those behind it count its
  /// messages.
  void add_port(const Crossing& crossing, std::size_t action) {
    if (!graph_.cut->port) {
      Entity entity;
      entity.kind = EntityKind::node;
      entity.id = {"Port", whole_.span};
      entity.path = whole_.path;
      entity.cpp = {"eagerx::Port", ""};  // in every program.hpp of what is cut out
      graph_.cut->port = std::make_shared<const Entity>(std::move(entity));
    }
    const Space& space = output_of(crossing).space;
    GraphNode node;
    node.name = "port/" + crossing.port.name;
    node.entity = graph_.cut->port.get();
    node.rate_hz = crossing.port.rate_hz;
    node.span = crossing.span;
    Input input;
    input.name = "signal";
    input.written = node.name + ".signal";
    input.source_node = Graph::kEnvironment;
    input.source_output = action;
    input.space = space;
    input.span = crossing.span;
    node.inputs.push_back(std::move(input));
    Output output;
    output.name = "value";
    output.raw = output.space = space;
    output.span = crossing.span;
    node.outputs.push_back(std::move(output));
    senders_.back() = {graph_.nodes.size(), 0};
    graph_.nodes.push_back(std::move(node));
  }

  void add_nodes() {
    moved_.assign(whole_.nodes.size(), kOutside);
    for (std::size_t n = 0, next = graph_.nodes.size(); n < whole_.nodes.size(); ++n)
      if (inside_[n]) moved_[n] = next++;
    for (std::size_t n = 0; n < whole_.nodes.size(); ++n) {
      if (!inside_[n]) continue;
      GraphNode node = whole_.nodes[n];
      node.entity = renamed(*node.entity);
      node.drawn = node.waits_during_reset = false;
      for (std::size_t i = 0; i < node.inputs.size(); ++i) {
        Input& input = node.inputs[i];
        if (inside_[input.source_node]) {
          input.source_node = moved_[input.source_node];
          continue;
        }
        const Sender& sender = senders_[crossings_.of_input.at({n, i})];
        input.source_node = sender.first;
        input.source_output = sender.second;
        input.sensor.clear();
      }
      graph_.nodes.push_back(std::move(node));
    }
  }

  /// A class that is generated for the graph, such as that of a policy, has the name of the library
  /// instead.
  const Entity* renamed(const Entity& entity) {
    const std::string of_whole = "graphs::" + whole_.name + "::";
    if (!entity.cpp.name.starts_with(of_whole)) return &entity;
    Entity copy = entity;
    const auto rename = [&](CppClass& cpp) {
      cpp.name = "graphs::" + graph_.name + "::" + cpp.name.substr(of_whole.size());
      cpp.include = graph_.name + cpp.include.substr(whole_.name.size());
    };
    rename(copy.cpp);
    if (copy.vectorized_cpp) rename(*copy.vectorized_cpp);
    return graph_.cut->generated.emplace_back(std::make_shared<const Entity>(std::move(copy)))
        .get();
  }

  /// Each takes what was sent in the step, so it skips that of the next instant.
  void add_observations() {
    for (const Crossing& crossing : crossings_.out) {
      Input input;
      input.name = crossing.port.name;
      input.written = "observations." + input.name;
      input.source_node = moved_[crossing.from.first];
      input.source_output = crossing.from.second;
      input.space = crossing.driven ? crossing.space : output_of(crossing).space;
      input.skip = true;
      input.span = crossing.span;
      graph_.nodes[Graph::kEnvironment].inputs.push_back(std::move(input));
      graph_.cut->observations.push_back(crossing.port);
    }
  }

  void add_safety() {
    Safety& safety = graph_.safety;
    safety = whole_.safety;
    safety.outputs.clear();
    safety.undeclared.clear();
    safety.frozen.clear();
    safety.actions.clear();
    const GraphNode& environment = graph_.environment();
    if (safety.max_lateness_s == Rational(1) / whole_.environment().rate_hz)
      safety.max_lateness_s = Rational(1) / environment.rate_hz;
    for (const Output& action : environment.outputs)
      safety.actions.push_back(zero_in(action.space));
    SafetySpec spec = request_.safety.value_or(SafetySpec());
    take_actuators(spec);
    const Setting* nodes = find_named(spec.settings, "nodes");
    if (nodes != nullptr) safety.resets_nodes = nodes->value.text == "reset";
    read_safe_outputs(environment, &spec, safety, diagnostics_);
  }

  /// Takes `safety: {actuators: …}` for the actuators that an output drives.
  void take_actuators(SafetySpec& spec) const {
    for (const CutPort& port : graph_.cut->observations) {
      if (!port.actuator || find_named(spec.outputs, port.name) != nullptr) continue;
      const Setting* actuator = find_named(spec.actuators, *port.actuator);
      if (actuator == nullptr) continue;
      SafeOutputSpec output;
      output.name = {port.name, actuator->span};
      output.span = actuator->span;
      output.value = actuator->value;
      spec.outputs.push_back(std::move(output));
    }
  }

  [[nodiscard]] const Output& output_of(const Crossing& crossing) const {
    return whole_.nodes[crossing.from.first].outputs[crossing.from.second];
  }

  const Graph& whole_;
  const CutRequest& request_;
  const std::vector<bool>& inside_;
  Crossings crossings_;
  Diagnostics& diagnostics_;
  Graph graph_;
  std::vector<Sender> senders_;     // of actions, by place in Crossings::in
  std::vector<std::size_t> moved_;  // places of nodes inside
};

}  // namespace

std::optional<Graph> cut_out(const Graph& whole, const CutRequest& request,
                             Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  CutRequest spelled = request;
  spelled.names = spelled_names(whole, request.names, diagnostics);
  const std::vector<bool> inside = choose_nodes(whole, spelled.names, diagnostics);
  if (inside.empty() || !check_order(whole, inside, diagnostics)) return std::nullopt;
  auto graph = Cutter(whole, spelled, inside, diagnostics).run();
  return diagnostics.error_count() == errors_before ? std::move(graph) : std::nullopt;
}

}  // namespace eagerx::gen
