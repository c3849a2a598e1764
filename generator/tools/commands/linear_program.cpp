#include "generator/tools/commands/linear_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <runtime/host/base/nearest.hpp>

#include "generator/frontend/read/scalar.hpp"
#include "generator/support/command_line/output.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/files/paths.hpp"
#include "generator/support/process/process.hpp"

namespace eagerx::gen {
namespace {

/// What keeps a policy from having derivatives; empty if it has some.
std::string why_no_derivative(const Network& network) {
  if (network.has_memory()) return "it remembers former observations";
  if (!network.is_chain()) return "its layers are not a chain";
  for (const Layer& layer : network.layers) {
    if (!layer.is_dense()) return "it has other layers than dense ones";
    if (!layer.rounded.empty()) return "its weights have eight bits";
  }
  return "";
}

/// Nodes with policies that the program cannot differentiate.
void check_policies_of(const Run& run, Diagnostics& diagnostics) {
  for (const NodePolicy& policy : node_policies(*run.spec, *run.graph, run.policies)) {
    std::string why = why_no_derivative(*policy.network);
    const ActionKind kind = policy.use.kind(*policy.network);
    if (kind == ActionKind::argmax || kind == ActionKind::binary) why = "it chooses among actions";
    if (why.empty()) continue;
    const GraphNode& node = run.graph->nodes[policy.node];
    diagnostics
        .error("E0520", node.span,
               fmt::format("the policy of `{}` has no derivatives: {}", node.name, why))
        .help =
        "linearize a variant with another controller, or with a policy of dense layers in "
        "float32";
  }
}

/// What cannot be linearized, at its place.
bool check_graph(const Graph& graph, Diagnostics& diagnostics) {
  if (graph.placement)
    diagnostics.error("E0520", graph.span, "a graph with parts cannot be linearized").help =
        "linearize a variant without `placement:`";
  if (graph.has_reset_nodes())
    diagnostics.error("E0520", graph.span, "a graph with reset nodes cannot be linearized");
  return !diagnostics.has_errors();
}

/// Steps until every window is full and every delay has passed.
std::uint64_t steps_until_full(const Plan& plan) {
  const Graph& graph = *plan.graph;
  double longest_s = 0.0;
  for (const GraphNode& node : graph.nodes) {
    for (const Input& input : node.inputs) {
      const double source_hz = graph.nodes[input.source_node].rate_hz.to_double();
      const Rational delay = input.max_delay_s ? *input.max_delay_s : input.delay_s;
      longest_s = std::max(longest_s, delay.to_double() + (input.window + 1) / source_hz);
    }
  }
  constexpr double kMost = 1e6;
  return static_cast<std::uint64_t>(
      std::min(kMost, 2.0 * longest_s * graph.environment().rate_hz.to_double() + 2.0));
}

}  // namespace

bool make_linear_graph(Run& run, LinearOptions& options) {
  options.targets = {"linearize"};
  options.purpose = Purpose::simulation;
  if (!make(run, options) || !check_graph(*run.graph, run.diagnostics)) return false;
  check_policies_of(run, run.diagnostics);
  return !run.diagnostics.has_errors();
}

std::size_t channel_at(const Plan& plan, std::size_t node, std::size_t output) {
  const auto found = std::ranges::find_if(plan.channels, [&](const Channel& each) {
    return each.node == node && each.output == output;
  });
  return static_cast<std::size_t>(found - plan.channels.begin());
}

const Space& space_of(const Plan& plan, std::size_t channel) {
  const Channel& sent = plan.channels[channel];
  return plan.graph->nodes[sent.node].outputs[sent.output].space;
}

std::vector<NamedChannel> port_names(const Plan& plan) {
  std::vector<NamedChannel> names;
  for (std::size_t c = 0; c < plan.channels.size(); ++c) {
    const Channel& channel = plan.channels[c];
    if (plan.graph->nodes[channel.node].role == NodeRole::engine) continue;
    names.push_back({channel.port, c});
    for (const std::string& alias : channel.aliases) names.push_back({alias, c});
    names.push_back({channel.name, c});
  }
  for (const GraphNode& node : plan.graph->nodes) {
    for (const Input& input : node.inputs) {
      const std::size_t channel = channel_at(plan, input.source_node, input.source_output);
      // What only pictures need has none.
      if (channel < plan.channels.size()) names.push_back({input.written, channel});
    }
  }
  return names;
}

std::optional<std::size_t> channel_of(const std::string& port, const std::string& about,
                                      const Plan& plan, Diagnostics& diagnostics) {
  const std::vector<NamedChannel> all = port_names(plan);
  const auto find = [&](const std::string& name) -> std::optional<std::size_t> {
    const auto found = std::ranges::find(all, name, &NamedChannel::name);
    return found != all.end() ? std::optional(found->channel) : std::nullopt;
  };
  auto channel = find(port);
  std::vector<std::string> names;
  for (const NamedChannel& each : all) names.push_back(each.name);
  const std::string* const meant = channel ? nullptr : host::name_meant(port, names);
  if (meant != nullptr) {
    diagnostics.note(plan.graph->span, fmt::format("`{}` is `{}` here", port, *meant));
    channel = find(*meant);
  }
  if (!channel) {
    // Without the names of channels, which repeat those of ports.
    std::erase_if(names, [](const std::string& name) { return name.find('.') == name.npos; });
    diagnostics.error("E0520", plan.graph->span, fmt::format("nothing sends `{}`", port)).help =
        suggestion(port, names);
    return std::nullopt;
  }
  if (is_floating(space_of(plan, *channel).dtype)) return channel;
  diagnostics
      .error("E0520", plan.graph->span,
             fmt::format("`{} {}`: its messages are {}, which have no derivative", about, port,
                         space_of(plan, *channel).describe()))
      .help = "name a port with messages of float32 or float64";
  return std::nullopt;
}

std::optional<PortElement> opened_port(const std::string& text, const Plan& plan,
                                       Diagnostics& diagnostics) {
  // Elements of arrays of nodes have an index too: "leg[2].u".
  const std::size_t bracket = text.ends_with(']') ? text.rfind('[') : std::string::npos;
  const auto channel = channel_of(text.substr(0, bracket), "--open", plan, diagnostics);
  if (!channel) return std::nullopt;
  const Channel& sent = plan.channels[*channel];
  const Span& span = plan.graph->span;
  if (sent.node == Graph::kEnvironment) {
    diagnostics
        .error("E0520", span,
               fmt::format("no loop goes through `{}`: the derivatives are those without an agent",
                           text))
        .help = "open the loop at what a node or a sensor sends";
    return std::nullopt;
  }
  const std::uint64_t size = space_of(plan, *channel).size();
  PortElement port{*channel, 0};
  if (bracket == std::string::npos && size == 1) return port;
  const auto index = bracket == std::string::npos
                         ? std::nullopt
                         : parse_int(text.substr(bracket + 1, text.size() - bracket - 2));
  if (index && *index >= 0 && static_cast<std::uint64_t>(*index) < size) {
    port.element = static_cast<std::uint64_t>(*index);
    return port;
  }
  diagnostics
      .error("E0520", span,
             fmt::format("a loop is opened at one number, and `{}` has {}", sent.port, size))
      .help = size == 1 ? fmt::format("write `{}`", sent.port)
                        : fmt::format("write `{0}[0]` to `{0}[{1}]`", sent.port, size - 1);
  return std::nullopt;
}

std::vector<NamedState> states_of(const Graph& graph) {
  std::vector<NamedState> states;
  for (const Object& object : graph.objects) {
    for (const State& state : object.states)
      states.push_back({object.name + "." + state.name, state.space.size()});
  }
  for (const GraphNode& node : graph.nodes) {
    for (const State& state : node.states) {
      if (state.settable) states.push_back({node.name + "." + state.name, state.space.size()});
    }
    for (const Input& input : node.inputs) {
      if (input.max_delay_s) states.push_back({node.name + "." + input.name + "/delay"});
    }
  }
  return states;
}

void check_state(const std::string& text, const Graph& graph, Diagnostics& diagnostics) {
  const std::size_t equals = text.find('=');
  const std::string name = text.substr(0, equals);
  std::vector<std::string> names;
  std::optional<NamedState> found;
  for (NamedState& state : states_of(graph)) {
    names.push_back(fmt::format("`{}` ({})", state.name, state.size));
    if (state.name == name) found = std::move(state);
  }
  std::size_t numbers = 0;
  bool good = equals != std::string::npos;
  for (std::size_t begin = equals + 1; good && begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const auto number = parse_number(text.substr(begin, end - begin));
    good = number && std::isfinite(*number);
    ++numbers;
    begin = end + 1;
  }
  if (found && good && numbers == found->size) return;
  diagnostics
      .usage_error("E0520",
                   fmt::format("`--at {}`: {}", text,
                               found ? "not one finite number for each element of the state"
                                     : "there is no such state"))
      .help = "states are " + join(names, ", ");
}

std::vector<std::string> first_words(const LinearOptions& options, const Plan& plan, bool settles) {
  std::vector<std::string> words = {
      "--steps", fmt::format("{}", options.steps.value_or(steps_until_full(plan))), "--seed",
      fmt::format("{}", options.seed.value_or(1))};
  for (const GraphNode& node : plan.graph->nodes) {
    if (node.role == NodeRole::node && settles) words.insert(words.end(), {"--settle", node.name});
  }
  return words;
}

std::optional<std::string> build_linear_program(Run& run, const LinearOptions& options, int& code) {
  const auto built = build_made_graph(run, options, code);
  if (!built) return std::nullopt;
  return absolute_path(built->back().image).string();
}

std::optional<std::string> printed_by(const std::string& image,
                                      const std::vector<std::string>& words, std::string& failure,
                                      int& code) {
  std::vector<std::string> command = {image};
  command.insert(command.end(), words.begin(), words.end());
  const auto result = run_process(command);
  if (result && result->exit_code == 0) return result->output;
  failure = result ? result->output : "error: the program could not be started\n";
  const bool has_problem = result && result->exit_code == kProblems;
  code = has_problem ? int{kProblems} : int{kWrongUsage};
  return std::nullopt;
}

namespace {

/// `read` of what the program prints; a problem is reported.
template <class Read>
auto read_printed(Run& run, const std::string& image, const std::vector<std::string>& words,
                  int& code, const Read& read) -> decltype(read(std::string_view(), *run.plan)) {
  std::string failure;
  const auto text = printed_by(image, words, failure, code);
  if (!text) {
    complain_text(failure);
    return std::nullopt;
  }
  auto result = read(*text, *run.plan);
  if (!result)
    run.diagnostics.error("E0520", run.graph->span, "the program has printed no matrices");
  return result;
}

}  // namespace

std::optional<SampledSystem> system_of(Run& run, const std::string& image,
                                       const std::vector<std::string>& words, int& code) {
  return read_printed(run, image, words, code, read_system);
}
std::optional<Hyperperiod> hyperperiod_of(Run& run, const std::string& image,
                                          const std::vector<std::string>& words, int& code) {
  return read_printed(run, image, words, code, read_hyperperiod);
}

}  // namespace eagerx::gen
