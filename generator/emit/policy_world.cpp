#include "generator/emit/policy_world.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace eagerx::gen {
namespace {

class WorldCheck {
 public:
  WorldCheck(const Graph& graph, const Network& network, Diagnostics& diagnostics)
      : graph_(graph), network_(network), diagnostics_(diagnostics) {}

  void run() {
    check_output();
    if (kind() == ActionKind::argmax) {
      check_choice();
    } else {
      check_bounds();
    }
    check_observations();
    check_shape();
    check_rate();
  }

 private:
  ActionKind kind() const {
    const auto& said = graph_.agent.output;
    if (!said) return network_.action_kind();
    if (*said == "argmax") return ActionKind::argmax;
    return *said == "squashed" ? ActionKind::squashed : ActionKind::raw;
  }

  Diagnostic& error(const char* code, const std::string& message) {
    return diagnostics_.error(code, graph_.agent.span, message);
  }

  void check_output() {
    if (!network_.action || *network_.action == kind()) return;
    error("E0704", fmt::format("the graph says that the policy's output is {}, but `{}` says {}",
                               to_string(kind()), graph_.agent.file, to_string(*network_.action)))
        .help = "leave `output` out";
  }

  /// One whole number, with as many values as the network has outputs.
  void check_choice() {
    const auto actions = actions_in_order(graph_);
    const Output& action = *actions.front();
    const bool whole = actions.size() == 1 && action.space.size() == 1 &&
                       !is_floating(action.space.dtype) && !action.space.low.empty() &&
                       !action.space.high.empty();
    if (!whole) {
      auto& problem = error(
          "E0704", fmt::format("the policy `{}` chooses one of {} actions by number, but the graph "
                               "has no single whole number as its action",
                               graph_.agent.file, network_.outputs()));
      problem.notes.push_back(
          {fmt::format("`actions.{}` is {}", action.name, action.space.describe()), action.span,
           ""});
      problem.help = fmt::format(
          "give it `space: {{dtype: int64, shape: [], low: 0, high: {}}}` and turn the number into "
          "a command with the processor `ChooseValue`",
          network_.outputs() - 1);
      return;
    }
    const double low = action.space.low.front();
    const double count = action.space.high.front() - low + 1.0;
    const bool same_start = !network_.contract.first_choice ||
                            low == static_cast<double>(*network_.contract.first_choice);
    if (count == static_cast<double>(network_.outputs()) && same_start) return;
    error(
        "E0705",
        fmt::format("the policy `{}` chooses from {} to {}, but the graph's action goes from {:g} "
                    "to {:g}",
                    graph_.agent.file, network_.contract.first_choice.value_or(0),
                    network_.contract.first_choice.value_or(0) + network_.outputs() - 1, low,
                    low + count - 1.0))
        .notes.push_back({"the action", action.span, ""});
  }

  static bool same(double a, double b) {
    constexpr double kFloat32 = 1e-6;  // the file may hold them in float32
    return a == b || std::fabs(a - b) <= kFloat32 * std::max(std::fabs(a), std::fabs(b));
  }

  /// Value `i` of bounds that are one for all, one for each, or not there.
  static std::optional<double> bound(const std::vector<double>& bounds, std::size_t i,
                                     std::size_t count) {
    if (bounds.size() == 1) return bounds.front();
    return bounds.size() == count ? std::optional<double>(bounds[i]) : std::nullopt;
  }

  void check_bounds() {
    const PolicyContract& contract = network_.contract;
    std::size_t output = 0;
    for (const Output* action : actions_in_order(graph_)) {
      const auto size = static_cast<std::size_t>(action->space.size());
      for (std::size_t i = 0; i < size; ++i, ++output) {
        const auto low = bound(contract.action_low, output, network_.outputs());
        const auto high = bound(contract.action_high, output, network_.outputs());
        const auto our_low = bound(action->space.low, i, size);
        const auto our_high = bound(action->space.high, i, size);
        if (!low || !high || !our_low || !our_high) continue;
        if (same(*low, *our_low) && same(*high, *our_high)) continue;
        auto& problem =
            error("E0705",
                  fmt::format("the policy `{}` was trained with actions from {:g} to {:g}, "
                              "but `actions.{}` goes from {:g} to {:g}",
                              graph_.agent.file, *low, *high, action->name, *our_low, *our_high));
        problem.notes.push_back({"the graph's action", action->span, ""});
        problem.help = fmt::format(
            "give the action the bounds of the training: `actions: {{{}: {{space: {{low: {:g}, "
            "high: {:g}}}}}}}`",
            action->name, *low, *high);
        return;
      }
    }
  }

  /// "angle (2), theta_dot"
  static std::string listed(const std::vector<PolicyContract::Part>& parts) {
    std::vector<std::string> texts;
    texts.reserve(parts.size());
    for (const auto& part : parts) {
      texts.push_back(part.size == 1 ? part.name : fmt::format("{} ({})", part.name, part.size));
    }
    return fmt::format("{}", fmt::join(texts, ", "));
  }

  void check_observations() {
    const auto& theirs = network_.contract.observations;
    if (theirs.empty() || graph_.agent.observations.empty()) return;
    std::vector<PolicyContract::Part> ours;
    for (const std::size_t i : graph_.agent.observations) {
      const Input& input = graph_.environment().inputs[i];
      ours.push_back({input.name, input.window * input.space.size()});
    }
    // Where each name starts and how long it is. Names that only one side has may be spelt
    // otherwise.
    const auto place =
        [](const std::vector<PolicyContract::Part>& parts,
           const std::string& name) -> std::optional<std::pair<std::uint64_t, std::uint64_t>> {
      std::uint64_t start = 0;
      for (const auto& part : parts) {
        if (part.name == name) return std::pair{start, part.size};
        start += part.size;
      }
      return std::nullopt;
    };
    bool common = false;
    bool differ = false;
    for (const auto& part : theirs) {
      const auto here = place(ours, part.name);
      common = common || here.has_value();
      differ = differ || (here && *here != *place(theirs, part.name));
    }
    if (common && !differ) return;
    const Span where = graph_.environment().inputs[graph_.agent.observations.front()].span;
    const std::string both = fmt::format("`{}` takes {}; the graph gives {}", graph_.agent.file,
                                         listed(theirs), listed(ours));
    if (!common) {
      auto& warning = diagnostics_.warning(
          "E0706", graph_.agent.span, "the names of the policy's observations are not the graph's");
      warning.notes.push_back({both, where, ""});
      warning.help = "their order was not checked: give the observations the names of the training";
      return;
    }
    auto& problem = error("E0706", "the policy's observations are not in the graph's order");
    problem.notes.push_back({both, where, ""});
    problem.help = "say the order of the training: `agent: {policy: …, observations: […]}`";
  }

  template <class Size>
  static std::vector<std::uint64_t> without_ones(const std::vector<Size>& shape) {
    std::vector<std::uint64_t> result;
    for (const Size size : shape) {
      if (size != 1) result.push_back(size);
    }
    return result;
  }

  /// An image or a stack of frames, for policies that know of places: frames come first, or are
  /// joined with the channels. Flat observations have no shape to compare.
  void check_shape() {
    if (network_.input_shape.size() < 2 || graph_.agent.observations.size() != 1) return;
    const Input& input = graph_.environment().inputs[graph_.agent.observations.front()];
    std::vector<std::uint64_t> stacked = input.space.shape;
    std::vector<std::uint64_t> joined = stacked;
    stacked.insert(stacked.begin(), input.window);
    if (joined.empty()) joined.push_back(1);
    joined.front() *= input.window;
    const auto wanted = without_ones(network_.input_shape);
    const auto ours = without_ones(stacked);
    if (ours.size() < 2 || ours == wanted || without_ones(joined) == wanted) return;
    auto& problem =
        error("E0708", fmt::format("the policy `{}` takes an observation of shape [{}], but "
                                   "`observations.{}` has [{}]",
                                   graph_.agent.file, fmt::join(network_.input_shape, ", "),
                                   input.name, fmt::join(ours, ", ")));
    problem.notes.push_back({"the observation, its window first", input.span, ""});
    problem.help = "images are channels first, then rows, then columns";
  }

  void check_rate() {
    const auto& rate = network_.contract.rate_hz;
    const double ours = graph_.environment().rate_hz.to_double();
    if (!rate || same(*rate, ours)) return;
    error("E0707",
          fmt::format("the policy `{}` was trained at {:g} Hz, but the graph runs at {:g} Hz",
                      graph_.agent.file, *rate, ours))
        .help = fmt::format("set `rate: {:g}`, and let nodes run faster behind it", *rate);
  }

  const Graph& graph_;
  const Network& network_;
  Diagnostics& diagnostics_;
};

}  // namespace

std::vector<const Output*> actions_in_order(const Graph& graph) {
  std::vector<const Output*> actions;
  for (const auto& action : graph.environment().outputs) actions.push_back(&action);
  std::sort(actions.begin(), actions.end(),
            [](const Output* a, const Output* b) { return a->name < b->name; });
  return actions;
}

void check_policy_world(const Graph& graph, const Network& network, Diagnostics& diagnostics) {
  WorldCheck(graph, network, diagnostics).run();
}

}  // namespace eagerx::gen
