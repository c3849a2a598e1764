// Compares the graph's actions with those of a policy's training.
#include <fmt/format.h>

#include <algorithm>

#include "generator/policy/agent/world_checks.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

class ActionCheck {
 public:
  ActionCheck(const PolicyUse& use, const Network& network, Diagnostics& diagnostics)
      : use_(use), network_(network), diagnostics_(diagnostics) {}

  void run() {
    check_output();
    if (kind() == ActionKind::binary) {
      check_bits();
    } else if (kind() == ActionKind::argmax && makes_several_choices()) {
      check_choices();
    } else if (kind() == ActionKind::argmax) {
      check_choice();
    } else {
      check_bounds();
    }
  }

 private:
  ActionKind kind() const { return use_.kind(network_); }

  Diagnostic& error(const char* code, const std::string& message) {
    return diagnostics_.error(code, use_.span, message);
  }

  void check_output() {
    if (!network_.action || *network_.action == kind()) return;
    const std::string& library = network_.action_of;
    const std::string theirs = library.empty() ? fmt::format("says {}", to_string(*network_.action))
                                               : fmt::format("is {}, whose output is {}", library,
                                                             to_string(*network_.action));
    error("E0704", fmt::format("the graph says that the policy's output is {}, but `{}` {}",
                               to_string(kind()), use_.file, theirs))
        .help = "leave `output` out";
  }

  /// A number of the graph's actions.
  struct Number {
    const Output* action;
    bool is_whole;
    double low, high;
  };
  std::vector<Number> numbers() const {
    std::vector<Number> result;
    for (const Output* action : use_.outputs) {
      const Space& space = action->raw;
      const auto size = static_cast<std::size_t>(space.size());
      for (std::size_t i = 0; i < size; ++i) {
        result.push_back({action, !is_floating(space.dtype),
                          bound_of(space.low, i, size).value_or(0.0),
                          bound_of(space.high, i, size).value_or(0.0)});
      }
    }
    return result;
  }

  /// The file says so, or says nothing and the graph has several numbers.
  bool makes_several_choices() const {
    const auto& groups = network_.contract.groups;
    return groups.size() > 1 || (groups.empty() && numbers().size() > 1);
  }

  /// Several whole numbers, each with as many values as it has outputs.
  void check_choices() {
    const auto& theirs = network_.contract.groups;
    const std::vector<Number> ours = numbers();
    const auto other = ranges::find_if(ours, [](const Number& number) { return !number.is_whole; });
    if (other != ours.end() || (!theirs.empty() && theirs.size() != ours.size())) {
      return need_whole_numbers(other != ours.end() ? *other->action : *use_.outputs.front());
    }
    double sum = 0.0;
    for (std::size_t i = 0; i < ours.size(); ++i) {
      const double count = ours[i].high - ours[i].low + 1.0;
      sum += count;
      const std::int64_t first = network_.contract.first_choice(i);
      const bool same_start = ours[i].low == static_cast<double>(first);
      if (theirs.empty() || (same_start && count == theirs[i])) continue;
      error("E0705",
            fmt::format("the policy `{}` chooses its number {} from {} to {}, but the "
                        "graph's goes from {:g} to {:g}",
                        use_.file, i, first, first + theirs[i] - 1, ours[i].low, ours[i].high))
          .notes.push_back(
              {fmt::format("`{}{}`", use_.out, ours[i].action->name), ours[i].action->span, ""});
      return;
    }
    if (sum == network_.outputs()) return;
    error("E0705", fmt::format("the policy `{}` gives {} scores, but the numbers of the graph's "
                               "actions have {:g} values together",
                               use_.file, network_.outputs(), sum))
        .notes.push_back({"the first action", use_.outputs.front()->span, ""});
  }

  void need_whole_numbers(const Output& action) {
    const auto& theirs = network_.contract.groups;
    auto& problem = error(
        "E0704", fmt::format("the policy `{}` chooses {}whole numbers, but the graph's "
                             "actions are others",
                             use_.file, theirs.empty() ? "" : fmt::format("{} ", theirs.size())));
    problem.notes.push_back(
        {fmt::format("`{}{}` is {}", use_.out, action.name, action.raw.describe()), action.span,
         ""});
    std::vector<std::int64_t> lows, highs;
    for (const std::uint32_t count : theirs) {
      lows.push_back(network_.contract.first_choice(lows.size()));
      highs.push_back(lows.back() + count - 1);
    }
    const bool is_from_zero = std::ranges::count(lows, 0) == std::ssize(lows);
    problem.help =
        theirs.empty()
            ? "give them `dtype: int64`, and as many values together as the policy has outputs"
            : fmt::format(
                  "write {} and turn its numbers into commands with a node",
                  space_entry(
                      action.name,
                      fmt::format("dtype: int64, shape: [{}], low: {}, high: [{}]", theirs.size(),
                                  is_from_zero ? "0" : fmt::format("[{}]", join(lows, ", ")),
                                  join(highs, ", "))));
  }

  /// Whole numbers from 0 to 1, as many as outputs: E0702 says so if not.
  void check_bits() {
    for (const Number& number : numbers()) {
      const bool fits = number.is_whole && number.low == 0.0 && number.high == 1.0;
      if (fits) continue;
      auto& problem =
          error("E0704",
                fmt::format("the policy `{}` answers with zeros and ones, but the graph's action "
                            "is something else",
                            use_.file));
      problem.notes.push_back({fmt::format("`{}{}` is {}", use_.out, number.action->name,
                                           number.action->raw.describe()),
                               number.action->span, ""});
      problem.help = fmt::format(
          "write {} and turn its numbers into commands with a node",
          space_entry(number.action->name, fmt::format("dtype: int64, shape: [{}], low: 0, high: 1",
                                                       network_.outputs())));
      return;
    }
  }

  /// One whole number, with as many values as the network has outputs.
  void check_choice() {
    const auto& actions = use_.outputs;
    const Output& action = *actions.front();
    const bool whole = actions.size() == 1 && action.raw.size() == 1 &&
                       !is_floating(action.raw.dtype) && !action.raw.low.empty() &&
                       !action.raw.high.empty();
    if (!whole) {
      auto& problem = error(
          "E0704", fmt::format("the policy `{}` chooses one of {} actions by number, but the graph "
                               "has no single whole number as its action",
                               use_.file, network_.outputs()));
      problem.notes.push_back(
          {fmt::format("`{}{}` is {}", use_.out, action.name, action.raw.describe()), action.span,
           ""});
      problem.help = fmt::format(
          "write {} and turn the number into a command with the processor `ChooseValue`",
          space_entry(action.name, fmt::format("dtype: int64, shape: [], low: 0, high: {}",
                                               network_.outputs() - 1)));
      return;
    }
    const double low = action.raw.low.front();
    const double count = action.raw.high.front() - low + 1.0;
    const bool same_start = network_.contract.first_choices.empty() ||
                            low == static_cast<double>(network_.contract.first_choice());
    if (count == static_cast<double>(network_.outputs()) && same_start) return;
    error("E0705",
          fmt::format(
              "the policy `{}` chooses from {} to {}, but the graph's action goes from {:g} "
              "to {:g}",
              use_.file, network_.contract.first_choice(),
              network_.contract.first_choice() + network_.outputs() - 1, low, low + count - 1.0))
        .notes.push_back({"the action", action.span, ""});
  }

  /// A space of an action, as it is written in the graph.
  std::string space_entry(const std::string& action, const std::string& space) const {
    return fmt::format("`{}: {{{}: {{space: {{{}}}}}}}`", use_.is_agent ? "actions" : "outputs",
                       action, space);
  }

  /// Other bounds change what reaches the robot, unless the training scaled its actions itself.
  std::string help_for_bounds(const std::string& action, double low, double high) const {
    const std::string bounds = space_entry(action, fmt::format("low: {:g}, high: {:g}", low, high));
    if (low != -1.0 || high != 1.0) {
      return fmt::format(
          "if the training acted in the same unit, give it the bounds of the training: {}", bounds);
    }
    return fmt::format(
        "if -1 and 1 stood for the bounds of the action (`make_vec_env(…, "
        "normalize_actions=True)`, "
        "Gymnasium's RescaleAction): `{}: …, normalize_actions: true}}`; if they are values of the "
        "action itself, give it these bounds: {}",
        use_.is_agent ? "agent: {policy" : "policy: {file", bounds);
  }

  void check_bounds() {
    const PolicyContract& contract = network_.contract;
    std::size_t output = 0;
    for (const Output* action : use_.outputs) {
      const auto size = static_cast<std::size_t>(action->raw.size());
      for (std::size_t i = 0; i < size; ++i, ++output) {
        const auto low = bound_of(contract.action_low, output, network_.outputs());
        const auto high = bound_of(contract.action_high, output, network_.outputs());
        const auto our_low = bound_of(action->raw.low, i, size);
        const auto our_high = bound_of(action->raw.high, i, size);
        if (!low || !high || !our_low || !our_high) continue;
        if (same_number(*low, *our_low) && same_number(*high, *our_high)) continue;
        auto& problem =
            error("E0705",
                  fmt::format("the policy `{}` was trained with actions from {:g} to {:g}, "
                              "but `{}{}` goes from {:g} to {:g}",
                              use_.file, *low, *high, use_.out, action->name, *our_low, *our_high));
        problem.notes.push_back(
            {use_.is_agent ? "the graph's action" : "the node's output", action->span, ""});
        problem.help = help_for_bounds(action->name, *low, *high);
        return;
      }
    }
  }

  const PolicyUse& use_;
  const Network& network_;
  Diagnostics& diagnostics_;
};

}  // namespace

void check_policy_actions(const PolicyUse& use, const Network& network, Diagnostics& diagnostics) {
  ActionCheck(use, network, diagnostics).run();
}

}  // namespace eagerx::gen
