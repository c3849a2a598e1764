#include "generator/graph/resolve/noise.hpp"

#include <fmt/format.h>

#include <utility>

#include "generator/graph/resolve/nodes.hpp"
#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

constexpr const char* kNoiseNode = "SensorModel";

YamlValue listed(const YamlValue& numbers) {
  return numbers.is_scalar() ? made_list({numbers}, numbers.span) : numbers;
}

std::string text_of(const NoiseSpec& noise) {
  std::vector<std::string> numbers;
  for (const YamlValue& number : listed(noise.numbers).items) numbers.push_back(number.text);
  return fmt::format("{}{}", noise.is_range ? "at most " : "deviation ", join(numbers, ", "));
}

/// As a graph would say it:
/// `noise_angle: {type: SensorModel, config: {noise: […]}, states: {seed: uniform}}`.
EntitySpec spec_of(const NoiseSpec& noise) {
  const Span span = noise.observation.span;
  EntitySpec spec;
  spec.name = {"noise_" + noise.observation.value, span};
  spec.type = {kNoiseNode, span};
  spec.config = {{noise.is_range ? "spread" : "noise", noise.numbers.span, listed(noise.numbers)}};
  RandomSpec uniform;
  uniform.span = span;
  StateSpec seed;
  seed.name = {"seed", span};
  seed.random = uniform;
  spec.states = {seed};
  return spec;
}

class NoiseAdder {
 public:
  explicit NoiseAdder(UnresolvedGraph& draft) : draft_(draft) {}

  void run() {
    for (const NoiseSpec& noise : draft_.spec.task->noise) {
      UnresolvedInput* const observation =
          draft_.nodes[Graph::kEnvironment].input(noise.observation.value);
      if (observation == nullptr) {
        report_unknown(noise.observation);
      } else if (observation->edge) {
        draft_.graph.task->noise.push_back({noise.observation.value, text_of(noise), add(noise)});
      }
    }
  }

 private:
  void report_unknown(const Spanned<std::string>& name) {
    draft_.diagnostics
        .error("E0307", name.span, fmt::format("there is no observation `{}`", name.value))
        .help = suggestion(name.value, names_of(draft_.nodes[Graph::kEnvironment].inputs),
                           "the graph has no observations");
  }

  /// Real hardware has its own noise.
  [[nodiscard]] bool is_simulated() const {
    const Entity* const engine = draft_.engine();
    return engine != nullptr && !engine->asynchronous;
  }

  std::optional<std::size_t> add(const NoiseSpec& noise) {
    if (!is_simulated()) return std::nullopt;
    const std::string name = "noise_" + noise.observation.value;
    if (const auto found = draft_.node_of_name.find(name); found != draft_.node_of_name.end()) {
      draft_.diagnostics
          .error("E0315", draft_.nodes[found->second].node.span,
                 fmt::format("the name `{}` is taken", name))
          .notes.push_back({"by the noise of an observation", noise.observation.span, ""});
      return std::nullopt;
    }
    const UnresolvedEdge edge = *observation(noise).edge;
    draft_.added.push_back(spec_of(noise));
    UnresolvedNode node = node_of(draft_, draft_.added.back(), {});
    node.node.rate_hz = draft_.nodes[edge.node].node.rate_hz;
    UnresolvedInput* const signal = node.input("signal");
    if (signal == nullptr) return std::nullopt;
    insert(*signal, observation(noise));
    draft_.nodes.push_back(std::move(node));
    draft_.node_of_name.try_emplace(name, draft_.nodes.size() - 1);
    return draft_.nodes.size() - 1;
  }

  UnresolvedInput& observation(const NoiseSpec& noise) {
    return *draft_.nodes[Graph::kEnvironment].input(noise.observation.value);
  }

  /// The observation's source becomes that of `signal`; window, delay and skip stay where they are,
  /// so that each message gets its noise once, and the delay stays the same.
  void insert(UnresolvedInput& signal, UnresolvedInput& observation) {
    signal.edge = observation.edge;
    signal.sensor = std::exchange(observation.sensor, {});
    signal.settings.processor = std::exchange(observation.settings.processor, std::nullopt);
    observation.edge = UnresolvedEdge{draft_.nodes.size(), 0, observation.edge->span};
  }

  UnresolvedGraph& draft_;
};

}  // namespace

void add_noise(UnresolvedGraph& draft) {
  if (draft.task) NoiseAdder(draft).run();
}

}  // namespace eagerx::gen
