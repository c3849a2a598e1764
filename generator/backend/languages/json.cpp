// part.json: a layout as text.
#include "generator/support/json/json.hpp"

#include <fmt/format.h>

#include "generator/backend/languages/layout.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

constexpr int kProtocol = 1;  // of the link: eagerx/link/frame.hpp

std::string fraction(const Rational& rate) {
  return fmt::format("{}/{}", rate.num(), rate.den());
}

template <class T>
Json listed(const std::vector<T>& values) {
  Json list = Json::list();
  for (const T& value : values) list.push_back(value);
  return list;
}

struct ConfigJson {
  Json operator()(const std::shared_ptr<const ModelUse>& model) const {
    return model->object->id.value;
  }
  template <class T>
  Json operator()(const std::vector<T>& values) const {
    return listed(values);
  }
  template <class T>
  Json operator()(const T& value) const {
    return value;
  }
};

void add_space(const Space& space, Json& into) {
  into["dtype"] = std::string(to_string(space.dtype));
  into["shape"] = listed(space.shape);
}

class LayoutWriter {
 public:
  LayoutWriter(const Plan& plan, const PartLayout& layout)
      : plan_(plan), graph_(*plan.graph), layout_(layout) {}

  Json run(std::uint64_t hash, const std::string& version) const {
    const PlacedPart& part = graph_.placement->parts[layout_.part];
    const PartLink& link = plan_.split->links[layout_.part];
    const std::size_t dot = version.find('.', version.find('.') + 1);
    Json json{{"format", "eagerx part 1"},
              {"graph", graph_.name},
              {"part", part.name},
              {"protocol", kProtocol},
              {"runtime", version.substr(0, dot)},
              {"hash", fmt::format("0x{:016x}", hash)},
              {"payload", Json{{"to_part", link.part_payload}, {"to_hub", link.hub_payload}}},
              {"depth", link.depth},
              {"decides", graph_.placement->part_of[Graph::kEnvironment] == layout_.part},
              {"safe_steps", graph_.safety.declared},
              {"step_rate", plan_.nodes[Graph::kEnvironment].rate},
              {"rates", rates()},
              {"messages", messages()},
              {"actions", listed(layout_.actions)},
              {"before", turns(layout_.before)},
              {"after", turns(layout_.after)},
              {"nodes", nodes()}};
    add_late(link, json);
    return json;
  }

 private:
  Json rates() const {
    Json list = Json::list();
    for (const RateClass& rate : plan_.rates)
      list.push_back(Json{{"rate", fraction(rate.rate_hz)}, {"period", rate.period}});
    return list;
  }

  /// Messages of other parts that the hub hands on later.
  void add_late(const PartLink& link, Json& json) const {
    if (ranges::all_of(link.lags, [](std::uint64_t lag) { return lag == 0; })) return;
    Json late = Json::object();
    for (std::size_t n = 0; n < link.lags.size(); ++n)
      if (link.lags[n] > 0) late[graph_.nodes[n].name] = link.lags[n];
    json["late"] = std::move(late);
  }

  Json messages() const {
    Json list = Json::list();
    for (const LayoutMessage& message : layout_.messages) {
      const Channel& channel = plan_.channels[message.channel];
      const GraphNode& node = graph_.nodes[channel.node];
      const Space& space = node.outputs[channel.output].space;
      Json item{{"name", channel.name},
                {"port", channel.port},
                {"to", message.to_hub ? "hub" : "part"},
                {"rate", fraction(node.rate_hz)}};
      add_space(space, item);
      if (!message.unit.empty()) item["unit"] = message.unit;
      if (!space.low.empty()) item["low"] = listed(space.low);
      if (!space.high.empty()) item["high"] = listed(space.high);
      item["offset"] = message.offset;
      item["bytes"] = message.bytes;
      item["keep"] = message.keep;
      list.push_back(std::move(item));
    }
    return list;
  }

  Json turns(const std::vector<LayoutTurn>& turns) const {
    Json list = Json::list();
    for (const LayoutTurn& turn : turns)
      list.push_back(Json{{"node", graph_.nodes[turn.node].name},
                          {"rate", plan_.nodes[turn.node].rate},
                          {"runs", turn.runs},
                          {"messages", listed(turn.messages)}});
    return list;
  }

  Json nodes() const {
    Json list = Json::list();
    for (const auto* turns : {&layout_.before, &layout_.after}) {
      for (const LayoutTurn& turn : *turns) {
        if (turn.runs) list.push_back(node(turn.node));
      }
    }
    return list;
  }

  Json node(std::size_t n) const {
    const GraphNode& node = graph_.nodes[n];
    Json config = Json::object(), states = Json::object();
    for (const ConfigValue& value : node.config)
      config[value.parameter->name.value] = std::visit(ConfigJson{}, value.value);
    for (const State& state : node.states) {
      if (!state.random) continue;
      Json item = Json::object();
      add_space(state.space, item);
      item["value"] = listed(state.random->first);
      states[state.name] = std::move(item);
    }
    return Json{{"name", node.name},
                {"type", node.entity->id.value},
                {"rate", fraction(node.rate_hz)},
                {"config", std::move(config)},
                {"states", std::move(states)},
                {"inputs", inputs(n)},
                {"outputs", outputs(n)}};
  }

  Json inputs(std::size_t n) const {
    Json list = Json::list();
    for (std::size_t i = 0; i < graph_.nodes[n].inputs.size(); ++i) {
      const Input& input = graph_.nodes[n].inputs[i];
      const Reception& reception = plan_.nodes[n].receptions[i];
      Json item{{"name", input.name},
                {"from", name_of_source(graph_, input)},
                {"message", layout_.find(plan_, input.source_node, input.source_output)},
                {"window", input.window},
                {"skip", input.skip},
                {"a", reception.a},
                {"b", reception.b},
                {"x", reception.x},
                {"off", reception.off}};
      if (input.processor) item["processor"] = input.processor->names();
      list.push_back(std::move(item));
    }
    return list;
  }

  Json outputs(std::size_t n) const {
    Json list = Json::list();
    for (std::size_t o = 0; o < graph_.nodes[n].outputs.size(); ++o) {
      const Output& output = graph_.nodes[n].outputs[o];
      Json item{{"name", output.name}, {"message", layout_.find(plan_, n, o)}};
      if (output.processor) item["processor"] = output.processor->names();
      list.push_back(std::move(item));
    }
    return list;
  }

  const Plan& plan_;
  const Graph& graph_;
  const PartLayout& layout_;
};

}  // namespace

std::string layout_json(const Plan& plan, const PartLayout& layout, std::uint64_t hash,
                        const std::string& version) {
  return dump_json(LayoutWriter(plan, layout).run(hash, version)) + "\n";
}

}  // namespace eagerx::gen
