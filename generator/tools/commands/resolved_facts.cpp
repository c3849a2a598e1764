#include "generator/tools/commands/resolved_facts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "generator/graph/plan/ages.hpp"
#include "generator/graph/plan/path_edge.hpp"

namespace eagerx::gen {
namespace {

constexpr std::size_t kMostForAges = 300;  // nodes

std::string milliseconds(const Rational& seconds) {
  const Rational in_ms = seconds * Rational(1000);
  return in_ms.is_integer() ? fmt::format("{} ms", in_ms.to_string())
                            : fmt::format("{:.1f} ms", in_ms.to_double());
}

/// "1 a tick", "3 a tick", "1 in 2 ticks", "2 in 3 ticks".
std::string per_tick(const Rational& source_hz, const Rational& own_hz) {
  const Rational each = source_hz / own_hz;
  if (each.is_integer()) return fmt::format("{} a tick", each.to_string());
  if (each.num() < each.den()) return fmt::format("{} in {} ticks", each.num(), each.den());
  return fmt::format("{:.2f} a tick", each.to_double());
}

std::string bounds_text(const std::vector<double>& bounds) {
  constexpr std::size_t kMost = 6;
  if (bounds.size() == 1) return fmt::format("{:g}", bounds.front());
  std::string text;
  for (std::size_t i = 0; i < std::min(bounds.size(), kMost); ++i)
    text += fmt::format("{}{:g}", i > 0 ? ", " : "", bounds[i]);
  return fmt::format("[{}{}]", text, bounds.size() > kMost ? ", …" : "");
}

std::string space_text(const Space& space) {
  std::string text = space.describe();
  if (!space.low.empty()) text += fmt::format(", from {}", bounds_text(space.low));
  if (!space.high.empty())
    text += fmt::format("{} to {}", space.low.empty() ? "," : "", bounds_text(space.high));
  return text;
}

class ResolvedFacts {
 public:
  explicit ResolvedFacts(const Run& run) : run_(run), graph_(*run.graph), plan_(*run.plan) {}

  lsp::Resolved all() {
    for (std::size_t n = 0; n < graph_.nodes.size(); ++n) {
      const GraphNode& node = graph_.nodes[n];
      for (const Output& output : node.outputs) sent(node, output);
      for (std::size_t i = 0; i < node.inputs.size(); ++i) received(n, i);
      if (node.role == NodeRole::node) of_node(node);
    }
    for (const Object& object : graph_.objects) of_object(object);
    if (graph_.nodes.size() <= kMostForAges) add_ages();
    composites();
    return std::move(facts_);
  }

 private:
  void sent(const GraphNode& node, const Output& output) {
    const std::string about =
        fmt::format("{}, {} Hz", space_text(output.space), node.rate_hz.to_string());
    const auto add = [&](const std::string& name) {
      facts_.ports.try_emplace(lsp::without_indices(name), about);
    };
    for (const std::string& sensor : output.sensors) add(sensor);
    if (node.role == NodeRole::environment) add("actions." + output.name);
    if (node.role == NodeRole::node) add(node.name + "." + output.name);
  }

  void received(std::size_t n, std::size_t i) {
    const GraphNode& node = graph_.nodes[n];
    const Input& input = node.inputs[i];
    const bool is_inner = node.role == NodeRole::engine_node && !input.actuator;
    if (is_inner || input.written.empty()) return;
    lsp::Resolved::Connection one;
    const GraphNode& source = graph_.nodes[input.source_node];
    one.per_tick = per_tick(source.rate_hz, node.rate_hz);
    if (const auto edge = make_path_edge(plan_, n, i))
      one.age = milliseconds(seconds(edge->newest_bound));
    one.defaulted = from_manifest(node, input);
    one.about = about(source, node, input, one);
    const std::string name = lsp::without_indices(input.written);
    facts_.ports.try_emplace(
        name, fmt::format("{}, {} Hz", space_text(input.space), node.rate_hz.to_string()));
    facts_.connections.try_emplace(name, std::move(one));
  }
  [[nodiscard]] std::string about(const GraphNode& source, const GraphNode& node,
                                  const Input& input, const lsp::Resolved::Connection& one) const {
    std::string text =
        fmt::format("`{}` → `{}`: {} Hz → {} Hz, {}, {}", name_of_source(graph_, input),
                    input.written, source.rate_hz.to_string(), node.rate_hz.to_string(),
                    one.per_tick, space_text(input.space));
    text += input.window == 0 ? "\n\nwindow: all that is new"
                              : fmt::format("\n\nwindow: {}", input.window);
    text += fmt::format(", delay: {}", milliseconds(input.delay_s));
    if (input.max_delay_s) text += fmt::format(", up to {}", milliseconds(*input.max_delay_s));
    if (input.skip) text += ", skip";
    if (input.processor) text += fmt::format(", processor: {}", input.processor->names());
    if (!one.age.empty()) text += fmt::format("\n\nthe newest message is at most {} old", one.age);
    return text;
  }
  /// Window and delay that the manifest says, and not the usual ones.
  static std::string from_manifest(const GraphNode& node, const Input& input) {
    const PortManifest* const port =
        node.entity != nullptr && !input.actuator ? node.entity->input(input.name) : nullptr;
    if (port == nullptr) return {};
    std::string text;
    if (port->settings.window && input.window != 1) text = fmt::format("window {}", input.window);
    if (port->settings.delay && input.delay_s != Rational())
      text += fmt::format("{}delay {}", text.empty() ? "" : ", ", milliseconds(input.delay_s));
    return text;
  }

  void of_node(const GraphNode& node) {
    const std::string name = lsp::without_indices(node.name);
    facts_.rates.try_emplace(name, node.rate_hz.to_string() + " Hz");
    std::string text = fmt::format("{} Hz", node.rate_hz.to_string());
    for (const Input& input : node.inputs)
      text += fmt::format("\n- in `{}`: {}", input.name, space_text(input.space));
    for (const Output& output : node.outputs)
      text += fmt::format("\n- out `{}`: {}", output.name, space_text(output.space));
    facts_.owners.try_emplace(name, std::move(text));
  }
  /// Of its ports in use.
  void of_object(const Object& object) {
    std::string text = fmt::format("on {}", graph_.engine_id());
    std::vector<Rational> rates;
    for (const GraphNode& node : graph_.nodes) {
      const auto add = [&](const std::string& port, const char* way, const Space& space) {
        if (!port.starts_with(object.name + ".")) return;
        rates.push_back(node.rate_hz);
        text += fmt::format("\n- {} `{}`: {}, {} Hz", way, port.substr(object.name.size() + 1),
                            space_text(space), node.rate_hz.to_string());
      };
      for (const Output& output : node.outputs) {
        for (const std::string& sensor : output.sensors) add(sensor, "sensor", output.space);
      }
      for (const Input& input : node.inputs) {
        if (input.actuator) add(input.written, "actuator", input.space);
      }
    }
    const std::string name = lsp::without_indices(object.name);
    facts_.owners.try_emplace(name, std::move(text));
    if (rates.empty()) return;
    const auto [least, most] = std::ranges::minmax(rates);
    facts_.rates.try_emplace(
        name, least == most ? fmt::format("{} Hz", least.to_string())
                            : fmt::format("{} to {} Hz", least.to_string(), most.to_string()));
  }

  void add_ages() {
    const DataAges ages(plan_, usual_ends(graph_));
    for (const DataAge& age : ages.known()) {
      const auto found = facts_.connections.find(lsp::without_indices(age.to));
      if (found == facts_.connections.end()) continue;
      std::string& text = found->second.about;
      text += fmt::format("\n\ndata of `{}` are at most {} old here", age.from,
                          milliseconds(age.newest_s));
      if (age.oldest_s) text += fmt::format(", the oldest {}", milliseconds(*age.oldest_s));
    }
  }

  /// Ports of composites: what they stand for.
  void composites() {
    for (const auto& [composite, ports] : run_.composites.composites()) {
      for (const auto& [name, sinks] : ports.sinks) {
        if (sinks.empty()) continue;
        const std::string port = fmt::format("{}.{}", composite, name);
        copy(facts_.connections, sinks.front().port, port);
        copy(facts_.ports, sinks.front().port, port);
      }
      for (const auto& [name, source] : ports.sources)
        copy(facts_.ports, source, fmt::format("{}.{}", composite, name));
    }
  }
  template <class Map>
  static void copy(Map& map, const std::string& from, const std::string& to) {
    const auto found = map.find(lsp::without_indices(from));
    if (found == map.end()) return;
    auto value = found->second;
    map.try_emplace(lsp::without_indices(to), std::move(value));
  }

  [[nodiscard]] Rational seconds(std::int64_t quanta) const {
    const RateClass& fastest = plan_.rates.front();
    return Rational(quanta) /
           (fastest.rate_hz * Rational(static_cast<std::int64_t>(fastest.period)));
  }

  const Run& run_;
  const Graph& graph_;
  const Plan& plan_;
  lsp::Resolved facts_;
};

}  // namespace

lsp::Resolved resolved_facts(const Run& run) {
  return ResolvedFacts(run).all();
}

}  // namespace eagerx::gen
