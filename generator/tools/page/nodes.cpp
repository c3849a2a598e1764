// Nodes with their inputs, outputs and parameters; where messages live, and when nodes run.
#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <type_traits>

#include "generator/analysis/info/info.hpp"
#include "generator/graph/plan/counts.hpp"
#include "generator/graph/plan/path_edge.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/tools/page/page.hpp"
#include "generator/tools/page/units.hpp"

namespace eagerx::gen {
namespace {

template <class T>
Json list_of(const std::vector<T>& values) {
  Json list = Json::list();
  for (const T& value : values) list.push_back(value);
  return list;
}

/// In quanta; nothing if it is so long that its time is no exact number.
std::optional<std::int64_t> hyperperiod_of(const std::vector<RateClass>& rates) {
  constexpr std::uint64_t kMost = std::uint64_t{1} << 53U;
  std::uint64_t product = 1;
  for (const RateClass& rate : rates) {
    const std::uint64_t factor = rate.period / std::gcd(product, rate.period);
    if (factor > kMost / product) return std::nullopt;
    product *= factor;
  }
  return static_cast<std::int64_t>(product);
}

/// Ticks whose messages are listed in a page, of all connections: two bytes each.
constexpr std::int64_t kMostTicks = 400'000;

/// Messages of a connection at each tick of its reader: `begin` at the first ones, then `cycle`
/// over and over. Null if these are more than `room`, which becomes smaller by them.
Json received_json(const PathEdge& edge, bool skip, std::int64_t& room) {
  const std::int64_t ticks = edge.settled + edge.b;
  if (ticks > room) return nullptr;
  room -= ticks;
  const Counts counts{edge.a, edge.b, edge.x, skip};
  const auto list = [&](std::int64_t from, std::int64_t to) {
    Json numbers = Json::list();
    for (std::int64_t n = from; n < to; ++n) numbers.push_back(counts.at(n));
    return numbers;
  };
  return Json{{"begin", list(0, edge.settled)},
              {"cycle", list(edge.settled, edge.settled + edge.b)}};
}

Json json_of(const Space& space) {
  return Json{{"text", space.describe()},
              {"numbers", space.size()},
              {"bytes", bytes_of(space)},
              {"low", list_of(space.low)},
              {"high", list_of(space.high)}};
}

/// JSON has no number for what is not finite.
Json number_of(double value) {
  if (std::isfinite(value)) return value;
  if (std::isnan(value)) return "not a number";
  return value > 0 ? "∞" : "−∞";
}

Json numbers_of(const std::vector<double>& values) {
  Json list = Json::list();
  for (const double value : values) list.push_back(number_of(value));
  return list;
}

Json json_of(const Config& config) {
  Json list = Json::list();
  for (const ConfigValue& item : config) {
    Json value = std::visit(
        [](const auto& held) {
          using Held = std::decay_t<decltype(held)>;
          if constexpr (std::is_same_v<Held, std::vector<std::int64_t>>)
            return list_of(held);
          else if constexpr (std::is_same_v<Held, std::vector<double>>)
            return numbers_of(held);
          else if constexpr (std::is_same_v<Held, double>)
            return number_of(held);
          else if constexpr (std::is_same_v<Held, std::shared_ptr<const ModelUse>>)
            return Json(held->object->id.value);
          else
            return Json(held);
        },
        item.value);
    list.push_back(Json{{"name", item.parameter->name.value},
                        {"value", std::move(value)},
                        {"unit", item.parameter->unit},
                        {"about", item.parameter->about},
                        {"given", item.given}});
  }
  return list;
}

Json json_of(const std::optional<Processor>& processor) {
  if (!processor) return nullptr;
  Json config = Json::list();
  for (const Processor* stage : processor->stages()) {
    const Json values = json_of(stage->config);
    for (const Json& value : *values.as<Json::List>()) config.push_back(value);
  }
  return Json{{"type", processor->names()}, {"config", std::move(config)}};
}

const char* name_of(RandomSpec::Kind kind) {
  switch (kind) {
    case RandomSpec::Kind::value:
      return "value";
    case RandomSpec::Kind::uniform:
      return "uniform";
    case RandomSpec::Kind::normal:
      return "normal";
    case RandomSpec::Kind::log_uniform:
      return "log-uniform";
    case RandomSpec::Kind::choice:
      break;
  }
  return "choice";
}

Json json_of(const std::optional<Random>& random) {
  if (!random) return nullptr;
  Json choices = Json::list();
  for (const auto& choice : random->choices) choices.push_back(list_of(choice));
  return Json{{"kind", name_of(random->kind)},
              {"first", list_of(random->first)},
              {"second", list_of(random->second)},
              {"choices", std::move(choices)}};
}

const char* name_of(NodeRole role) {
  switch (role) {
    case NodeRole::environment:
      return "environment";
    case NodeRole::engine:
      return "engine";
    case NodeRole::node:
      return "node";
    case NodeRole::engine_node:
      break;
  }
  return "engine node";
}

class Nodes {
 public:
  explicit Nodes(const PageContents& contents)
      : contents_(contents), plan_(*contents.info->plan), graph_(*plan_.graph) {}

  void add_to(Json& page) {
    page["schedule"] = schedule();
    Json& nodes = page["nodes"] = Json::list();
    for (std::size_t n = 0; n < graph_.nodes.size(); ++n) nodes.push_back(node(n));
    Json& objects = page["objects"] = Json::list();
    for (const Object& object : graph_.objects) objects.push_back(object_json(object));
    Json& composites = page["composites"] = Json::list();
    for (const CompositeSpec& composite : contents_.spec->composites)
      composites.push_back(
          Json{{"name", composite.name},
               {"type", composite.type},
               {"about", composite.about},
               {"rate", composite.rate_hz ? Json(composite.rate_hz->to_string()) : Json(nullptr)},
               {"line", line_of(composite.span)}});
    Json& rings = page["rings"] = Json::list();
    for (const Ring& ring : plan_.rings) rings.push_back(ring_json(ring));
    Json& channels = page["channels"] = Json::list();
    for (const Channel& channel : plan_.channels)
      channels.push_back(
          Json{{"name", channel.name}, {"node", channel.node}, {"output", channel.output}});
    page["safety"] = safety();
  }

 private:
  /// Of the graph's file; of what is in a composite, that of the composite.
  std::uint32_t line_of(const Span& span) const {
    return contents_.sources->place_in(contents_.spec->file, span).line;
  }

  Json json_of_states(const std::vector<State>& states) const {
    Json list = Json::list();
    for (const State& state : states) {
      if (!state.settable) continue;
      list.push_back(Json{{"name", state.name},
                          {"space", json_of(state.space)},
                          {"random", json_of(state.random)},
                          {"line", line_of(state.span)}});
    }
    return list;
  }

  /// Of the grid that all ticks lie on.
  Rational quantum_s() const {
    const RateClass& fastest = plan_.rates.front();
    return Rational(1) / (fastest.rate_hz * Rational(static_cast<std::int64_t>(fastest.period)));
  }

  Json schedule() const {
    Json json{{"quantum", time_json(quantum_s())},
              {"form", text_of(plan_.schedule.form)},
              {"asynchronous", graph_.asynchronous}};
    json["slots"] = plan_.schedule.slots ? Json(*plan_.schedule.slots) : Json(nullptr);
    const auto hyperperiod = hyperperiod_of(plan_.rates);
    json["hyperperiod"] =
        hyperperiod ? time_json(Rational(*hyperperiod) * quantum_s()) : Json(nullptr);
    std::vector<std::size_t> order = plan_.before;
    order.push_back(Graph::kEnvironment);
    order.insert(order.end(), plan_.after.begin(), plan_.after.end());
    json["order"] = list_of(order);
    json["rates"] = Json::list();
    for (const RateClass& rate : plan_.rates)
      json["rates"].push_back(Json{{"rate", rate.rate_hz.to_string()}, {"period", rate.period}});
    return json;
  }

  Json node(std::size_t n) {
    const GraphNode& node = graph_.nodes[n];
    Json json{{"name", node.name},
              {"role", node.is_reset_node() ? "reset node" : name_of(node.role)},
              {"type", node.entity != nullptr ? Json(node.entity->id.value) : Json(nullptr)},
              {"about", node.entity != nullptr ? node.entity->summary : std::string()},
              {"rate", node.rate_hz.to_string()},
              {"rate_class", plan_.nodes[n].rate},
              {"line", line_of(node.span)},
              {"config", json_of(node.config)},
              {"states", json_of_states(node.states)}};
    json["object"] = node.object ? Json(*node.object) : Json(nullptr);
    json["inputs"] = Json::list();
    for (std::size_t i = 0; i < node.inputs.size(); ++i) json["inputs"].push_back(input(n, i));
    json["outputs"] = Json::list();
    for (std::size_t o = 0; o < node.outputs.size(); ++o)
      json["outputs"].push_back(
          Json{{"name", node.outputs[o].name},
               {"sensor", fmt::format("{}", join(node.outputs[o].sensors, ", "))},
               {"space", json_of(node.outputs[o].space)},
               {"unit", unit_of(graph_, node, node.outputs[o])},
               {"processor", json_of(node.outputs[o].processor)}});
    return json;
  }

  Json input(std::size_t n, std::size_t i) {
    const Input& input = graph_.nodes[n].inputs[i];
    const Reception& reception = plan_.nodes[n].receptions[i];
    Json json{{"name", input.name},
              {"written", input.written},
              {"from", name_of_source(graph_, input)},
              {"source", Json::List{input.source_node, input.source_output}},
              {"space", json_of(input.space)},
              {"window", input.window},
              {"delay", time_json(input.delay_s)},
              {"skip", input.skip},
              {"processor", json_of(input.processor)},
              {"random_delay", json_of(input.random_delay)},
              {"ring", reception.ring},
              {"most", reception.max_size},
              {"keep", reception.keep},
              {"line", line_of(input.span)}};
    json["longest_delay"] = input.max_delay_s ? time_json(*input.max_delay_s) : Json(nullptr);
    const auto edge = graph_.asynchronous ? std::nullopt : make_path_edge(plan_, n, i);
    json["hop"] = hop_json(edge);
    json["received"] = edge ? received_json(*edge, input.skip, room_) : Json(nullptr);
    return json;
  }

  /// Null where messages do not come by count, or too far apart.
  Json hop_json(const std::optional<PathEdge>& edge) const {
    if (!edge) return nullptr;
    return Json{{"a", edge->a},
                {"b", edge->b},
                {"newest", time_json(Rational(edge->newest_bound) * quantum_s())},
                {"oldest", time_json(Rational(edge->oldest_bound) * quantum_s())}};
  }

  Json object_json(const Object& object) const {
    Json engine;
    if (object.implementation != nullptr) engine = object.implementation->engine.value;
    return Json{{"name", object.name},
                {"type", object.entity->id.value},
                {"about", object.entity->summary},
                {"engine", std::move(engine)},
                {"config", json_of(object.config)},
                {"states", json_of_states(object.states)},
                {"line", line_of(object.span)}};
  }
  static Json ring_json(const Ring& ring) {
    Json reader;
    if (ring.reader_node) reader = Json(Json::List{*ring.reader_node, *ring.reader_input});
    return Json{{"node", ring.node},
                {"output", ring.output},
                {"reader", std::move(reader)},
                {"space", json_of(ring.space)},
                {"needed", ring.needed},
                {"messages", ring.capacity},
                {"bytes", ring.capacity * bytes_of(ring.space)},
                {"why", ring.why}};
  }

  Json safety() const {
    const Safety& safety = graph_.safety;
    if (!safety.declared) return nullptr;
    Json json{{"late", safety.late},
              {"missed", safety.missed},
              {"recover", safety.recover},
              {"max_lateness", time_json(safety.max_lateness_s)},
              {"link_timeout", time_json(safety.link_timeout_s)},
              {"heartbeat_timeout", time_json(safety.heartbeat_timeout_s)},
              {"clips", safety.clips},
              {"holds", safety.holds},
              {"line", line_of(safety.span)},
              {"actions", Json::list()}};
    for (std::size_t a = 0; a < safety.actions.size(); ++a)
      json["actions"].push_back(Json{{"name", graph_.environment().outputs[a].name},
                                     {"value", list_of(safety.actions[a])}});
    return json;
  }

  const PageContents& contents_;
  const Plan& plan_;
  const Graph& graph_;
  std::int64_t room_ = kMostTicks;
};

}  // namespace

void add_nodes(const PageContents& contents, Json& page) {
  Nodes(contents).add_to(page);
}

}  // namespace eagerx::gen
