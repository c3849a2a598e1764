// graph.hpp: facts for a main loop, domain randomization, inputs and outputs of the policy.
#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "generator/backend/emit/names.hpp"
#include "generator/backend/emit/policy_answers.hpp"
#include "generator/backend/emit/samples.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/quote/quote.hpp"

namespace eagerx::gen {
namespace {

class GraphView {
 public:
  GraphView(const Plan& plan, const ProgramNames& names, const std::optional<Network>& network,
            const std::vector<NodePolicy>& node_policies)
      : plan_(plan),
        graph_(*plan.graph),
        names_(names),
        network_(network),
        node_policies_(node_policies) {
    constants_.unique("kName");
    for (const char* taken : {"kEngine", "kDefaultAgent", "kAgentCsv", "kHasPolicy", "kChannels",
                              "kShapes", "kAliases"})
      constants_.unique(taken);
  }

  View make() {
    view_.set("engine", graph_.engine_id());
    view_.set("rate_type", rate_type(graph_.environment().rate_hz));
    view_.set("agent", agent_name());
    view_.set("agent_csv",
              cpp_string(graph_.agent.kind == AgentSpec::Kind::csv ? graph_.agent.file : ""));
    add_channels();
    add_samples();
    add_states();
    add_random_action();
    add_policy();
    add_split();
    view_["task"] = outcome_view(plan_, names_);
    view_["render"] = render_view();
    view_["telemetry"] = telemetry_view(plan_);
    return std::move(view_);
  }

  /// Only what is sampled.
  View sampler() {
    add_samples();
    return std::move(view_);
  }

 private:
  View render_view() const {
    if (!graph_.render || !names_.runs(graph_.render->node)) return View(false);
    View view = object();
    view.set("rate_type", rate_type(graph_.nodes[graph_.render->node].rate_hz));
    view.set("io", names_.nodes[graph_.render->node].io);
    return view;
  }

  std::string agent_name() const {
    switch (graph_.agent.kind) {
      case AgentSpec::Kind::zero:
        return "zero";
      case AgentSpec::Kind::random:
        return "random";
      case AgentSpec::Kind::csv:
        return "csv";
      case AgentSpec::Kind::policy:
        break;
    }
    return "policy";
  }

  static std::string publisher(NodeRole role) {
    switch (role) {
      case NodeRole::environment:
        return "environment";
      case NodeRole::engine:
        return "engine";
      case NodeRole::engine_node:
        return "engine_node";
      case NodeRole::node:
        break;
    }
    return "node";
  }

  /// `{low, high}` for all elements or for each; nothing where every value is within.
  static std::vector<std::string> bounds_of(const Space& space) {
    const bool is_float = space.dtype == Dtype::float32;
    const auto bound = [&](const std::vector<double>& given, std::size_t i, double otherwise) {
      const double value = given.empty() ? otherwise : given[given.size() == 1 ? 0 : i];
      return is_float ? static_cast<double>(static_cast<float>(value)) : value;
    };
    const double lowest = bound({}, 0, lowest_of(space.dtype));
    const double highest = bound({}, 0, highest_of(space.dtype));
    const std::size_t count = std::max({space.low.size(), space.high.size(), std::size_t{1}});
    std::vector<std::string> result;
    bool bounded = false;
    for (std::size_t i = 0; i < count; ++i) {
      const double low = bound(space.low, i, lowest), high = bound(space.high, i, highest);
      bounded = bounded || low > lowest || high < highest;
      result.push_back(
          fmt::format("{{{}, {}}}", literal(low, Dtype::float64), literal(high, Dtype::float64)));
    }
    return bounded ? result : std::vector<std::string>();
  }

  void add_channels() {
    View channels = list(), bounds = list(), shapes = list(), aliases = list();
    std::size_t first = 0, number = 0;
    for (const auto& channel : plan_.channels) {
      const GraphNode& node = graph_.nodes[channel.node];
      const Space& space = node.outputs[channel.output].space;
      View item = object();
      item.set("channel", channel.name);
      item.set("dtype", std::string(to_string(space.dtype)));
      item.set("size", fmt::format("{}", space.size()));
      item.set("num", fmt::format("{}", node.rate_hz.num()));
      item.set("den", fmt::format("{}", node.rate_hz.den()));
      item.set("publisher", publisher(node.role));
      item.set("port", channel.port);
      const std::vector<std::string> own = bounds_of(space);
      if (!own.empty()) {
        View place = object();
        place.set("first", fmt::format("{}", first));
        place.set("count", fmt::format("{}", own.size()));
        item["bounded"] = std::move(place);
        for (std::size_t i = 0; i < own.size(); ++i) {
          View line = object();
          line.set("values", own[i]);
          line.set("channel",
                   own.size() == 1 ? channel.name : fmt::format("{}[{}]", channel.name, i));
          bounds.push_back(std::move(line));
        }
        first += own.size();
      } else {
        item["bounded"] = View(false);
      }
      if (!space.shape.empty()) {
        View line = object();
        line.set("place", fmt::format("{{{}, \"{}\"}}", number, join(space.shape, "x")));
        line.set("channel", channel.name);
        shapes.push_back(std::move(line));
      }
      for (const std::string& port : channel.aliases) {
        View line = object();
        line.set("place", fmt::format("{{{}, \"{}\"}}", number, port));
        line.set("channel", channel.name);
        aliases.push_back(std::move(line));
      }
      channels.push_back(std::move(item));
      ++number;
    }
    view_.set("has_shapes", shapes.is_non_empty_list());
    view_["shapes"] = std::move(shapes);
    view_.set("has_aliases", aliases.is_non_empty_list());
    view_["aliases"] = std::move(aliases);
    view_.set("has_bounds", bounds.is_non_empty_list());
    view_["bounds"] = std::move(bounds);
    view_["channels"] = std::move(channels);
  }

  /// Whether a reset node brings this state about: then both programs ask for it.
  bool is_target(std::size_t owner, std::size_t state, bool object) const {
    for (const auto& node : graph_.nodes) {
      for (const auto& target : node.reset_targets) {
        if (target.state == state && target.object.has_value() == object &&
            (object ? *target.object : target.node) == owner)
          return true;
      }
    }
    return false;
  }

  void add_split() {
    view_.set("is_split", names_.is_split());
    view_.set("is_hub", names_.is_hub());
    if (!names_.is_split()) return;
    const std::size_t decides = graph_.placement->part_of[Graph::kEnvironment];
    view_.set("decides_there", bool_literal(names_.is_hub() ? decides != Placement::kHub
                                                            : names_.runs(Graph::kEnvironment)));
    View parts = list();
    const auto& placed = graph_.placement->parts;
    for (std::size_t part = 0; part < placed.size(); ++part) {
      if (!names_.is_hub() && part != names_.program().index()) continue;
      const PartLink& link = plan_.split->links[part];
      View item = object();
      item.set("part", placed[part].name);
      item.set("target", placed[part].target->id.value);
      item.set("machine", placed[part].host);
      item.set("to_board", fmt::format("{}", link.part_payload));
      item.set("to_host", fmt::format("{}", link.hub_payload));
      item.set("depth", fmt::format("{}", link.depth));
      item.set("is_deep", link.depth > 1);
      item.set("comma", part + 1 < placed.size() ? ", " : "");
      parts.push_back(std::move(item));
    }
    view_["parts"] = std::move(parts);
  }

  void add_samples() {
    View ranges = list(), randoms = list();
    bool samples = false;
    const auto add = [&](const std::string& owner, const State& state, const std::string& field) {
      if (!state.random) return;
      const RandomSpec::Kind kind = state.random->kind;
      std::string constant;
      if (needs_range(*state.random)) {
        View item = space_view(field, range_of(*state.random, state.space), "State", constants_);
        constant = item.get("constant")->string_value();
        item.set("state", owner + "." + state.name);
        ranges.push_back(std::move(item));
      }
      View item = object();
      item.set("state", owner + "/" + state.name);
      item.set("needs_random", kind != RandomSpec::Kind::value);
      item.set("constant", constant);
      item.set("field", field);
      item.set("is_together",
               kind == RandomSpec::Kind::uniform && state.space.dtype == Dtype::float32);
      item.set("lines", sample_lines(*state.random, state.space, field, constant));
      randoms.push_back(std::move(item));
      samples = samples || kind != RandomSpec::Kind::value;
    };
    for (std::size_t i = 0; i < graph_.objects.size(); ++i) {
      for (std::size_t s = 0; s < graph_.objects[i].states.size(); ++s)
        if (names_.has_engine() || is_target(i, s, true))
          add(graph_.objects[i].name, graph_.objects[i].states[s],
              names_.objects[i].states[s].field);
    }
    for (std::size_t n = 0; n < graph_.nodes.size(); ++n) {
      for (std::size_t s = 0; s < graph_.nodes[n].states.size(); ++s)
        if (names_.runs(n) || is_target(n, s, false))
          add(graph_.nodes[n].name, graph_.nodes[n].states[s], names_.nodes[n].states[s].field);
    }
    for (std::size_t n = 0; n < graph_.nodes.size(); ++n) {
      for (std::size_t i = 0; i < graph_.nodes[n].inputs.size(); ++i) {
        const Input& input = graph_.nodes[n].inputs[i];
        if (!input.random_delay || !names_.receives(n)) continue;
        State delay;
        delay.name = input.name + "/delay";
        delay.space = {Dtype::float64, {}, {0.0}, {input.max_delay_s->to_double()}};
        delay.random = input.random_delay;
        add(graph_.nodes[n].name, delay, names_.nodes[n].inputs[i].delay_state);
      }
    }
    view_.set("has_ranges", ranges.is_non_empty_list());
    view_["ranges"] = std::move(ranges);
    view_["randoms"] = std::move(randoms);
    view_.set("samples", samples);
  }

  /// Everything that States has.
  void add_states() {
    View states = list();
    std::vector<std::string> tunable;
    const auto add = [&](const std::string& owner, const std::string& name, const Space& space,
                         const std::string& field, bool tunes_running = false) {
      tunable.emplace_back(tunes_running ? "true" : "false");
      View item = object();
      item.set("state", owner + "." + name);
      item.set("id", owner + "/" + name);
      item.set("field", field);
      item.set("type", message_type(space));
      item.set("literal", space_literal(space));
      states.push_back(std::move(item));
    };
    for (std::size_t i = 0; i < graph_.objects.size(); ++i) {
      const Object& item = graph_.objects[i];
      for (std::size_t s = 0; s < item.states.size(); ++s)
        add(item.name, item.states[s].name, item.states[s].space,
            names_.objects[i].states[s].field);
    }
    for (std::size_t n = 0; n < graph_.nodes.size(); ++n) {
      const GraphNode& node = graph_.nodes[n];
      for (std::size_t s = 0; s < node.states.size(); ++s) {
        if (node.states[s].settable)
          add(node.name, node.states[s].name, node.states[s].space, names_.nodes[n].states[s].field,
              node.states[s].tunes_running && names_.runs(n));
      }
      for (std::size_t i = 0; i < node.inputs.size(); ++i) {
        if (names_.nodes[n].inputs[i].delay_state.empty()) continue;
        add(node.name, node.inputs[i].name + "/delay",
            {Dtype::float64, {}, {0.0}, {node.inputs[i].max_delay_s->to_double()}},
            names_.nodes[n].inputs[i].delay_state);
      }
    }
    const bool tunes = std::ranges::count(tunable, "true") > 0;
    view_.set("tunable", tunes ? joined(tunable) : "");
    view_.set("has_tunable", tunes);
    view_.set("has_states", states.is_non_empty_list());
    view_["states"] = std::move(states);
  }

  void add_random_action() {
    std::vector<FieldValue> samples;
    std::uint64_t words = 0;
    Names constants;  // the same names as in limits_view()
    for (const auto& action : graph_.environment().outputs) {
      const std::string constant = constants.unique("kAction" + camel(action.name));
      samples.push_back({action.name, constant + ".sample(random)"});
      words += action.space.size() * 2;
    }
    constexpr std::uint64_t kWordsInBlock = 4;
    view_.set("has_random_action", !samples.empty());
    view_.set("random_action", designated(samples));
    // Twice what is needed, since sampling an integer may take several words.
    view_.set("samples_a_step",
              fmt::format("{}", std::bit_ceil(2 * (words + kWordsInBlock - 1) / kWordsInBlock)));
  }

  void add_self_tests() {
    std::size_t rows = network_ ? network_->self_test.size() : 0;
    std::vector<std::string> tests;
    bool is_fast = network_ && network_->profile == Profile::fast;
    if (network_) tests.emplace_back("policy::self_test()");
    for (const NodePolicy& policy : node_policies_) {
      rows += policy.network->self_test.size();
      is_fast = is_fast || policy.network->profile == Profile::fast;
      tests.push_back(policy_namespace(graph_.nodes[policy.node].name) + "::self_test()");
    }
    view_.set("has_fast", is_fast);
    view_.set("self_test_rows", fmt::format("{}", rows));
    view_.set("self_tests", tests.empty() ? "true" : fmt::format("{}", join(tests, " && ")));
  }

  void add_policy() {
    View inputs = list();
    view_.set("has_policy", network_.has_value());
    view_.set("has_memory", network_ && network_->has_memory());
    view_.set("policy_flag", bool_literal(network_.has_value()));
    view_.set("policy_file", graph_.agent.file);
    add_self_tests();
    if (!network_) return;
    for (const std::size_t i : graph_.agent.observations) {
      View item = object();
      item.set("field", graph_.environment().inputs[i].name);
      inputs.push_back(std::move(item));
    }
    const PolicyUse use = agent_use(graph_);
    view_["policy_inputs"] = std::move(inputs);
    view_["policy_outputs"] = policy_answers(use, *network_, "kAction");
    view_.set("reads_in_order", reads_in_order(use, *network_));
  }

  const Plan& plan_;
  const Graph& graph_;
  const ProgramNames& names_;
  const std::optional<Network>& network_;
  const std::vector<NodePolicy>& node_policies_;
  Names constants_;
  View view_ = object();
};

}  // namespace

View graph_view(const Plan& plan, const ProgramNames& names, const std::optional<Network>& network,
                const std::vector<NodePolicy>& node_policies) {
  return GraphView(plan, names, network, node_policies).make();
}

View sampler_view(const Plan& plan, const ProgramNames& names) {
  const std::optional<Network> no_network;
  return GraphView(plan, names, no_network, {}).sampler();
}

}  // namespace eagerx::gen
