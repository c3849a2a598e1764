#include "generator/agent/world.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/agent/order.hpp"

namespace eagerx::gen {
namespace {

class WorldCheck {
 public:
  WorldCheck(const PolicyUse& use, const Network& network, Diagnostics& diagnostics)
      : use_(use), network_(network), diagnostics_(diagnostics) {}

  void run() {
    const std::size_t errors_before = diagnostics_.error_count();
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
    check_observations();
    check_shape();
    check_rate(diagnostics_.error_count() == errors_before);
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
                          bound(space.low, i, size).value_or(0.0),
                          bound(space.high, i, size).value_or(0.0)});
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
    const auto other =
        std::ranges::find_if(ours, [](const Number& number) { return !number.is_whole; });
    if (other != ours.end() || (!theirs.empty() && theirs.size() != ours.size())) {
      return need_whole_numbers(other != ours.end() ? *other->action : *use_.outputs.front());
    }
    double sum = 0.0;
    for (std::size_t i = 0; i < ours.size(); ++i) {
      const double count = ours[i].high - ours[i].low + 1.0;
      sum += count;
      if (theirs.empty() || (ours[i].low == 0.0 && count == theirs[i])) continue;
      error("E0705", fmt::format("the policy `{}` chooses its number {} from 0 to {}, but the "
                                 "graph's goes from {:g} to {:g}",
                                 use_.file, i, theirs[i] - 1, ours[i].low, ours[i].high))
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
    std::vector<std::uint32_t> highs;
    highs.reserve(theirs.size());
    for (const std::uint32_t count : theirs) highs.push_back(count - 1);
    problem.help =
        theirs.empty()
            ? "give them `dtype: int64`, and as many values together as the policy has outputs"
            : fmt::format(
                  "give it `space: {{dtype: int64, shape: [{}], low: 0, high: [{}]}}` and "
                  "turn its numbers into commands with a node",
                  theirs.size(), fmt::join(highs, ", "));
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
          "give it `space: {{dtype: int64, shape: [{}], low: 0, high: 1}}` and turn its numbers "
          "into "
          "commands with a node",
          network_.outputs());
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
          "give it `space: {{dtype: int64, shape: [], low: 0, high: {}}}` and turn the number into "
          "a command with the processor `ChooseValue`",
          network_.outputs() - 1);
      return;
    }
    const double low = action.raw.low.front();
    const double count = action.raw.high.front() - low + 1.0;
    const bool same_start = !network_.contract.first_choice ||
                            low == static_cast<double>(*network_.contract.first_choice);
    if (count == static_cast<double>(network_.outputs()) && same_start) return;
    error(
        "E0705",
        fmt::format("the policy `{}` chooses from {} to {}, but the graph's action goes from {:g} "
                    "to {:g}",
                    use_.file, network_.contract.first_choice.value_or(0),
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
    for (const Output* action : use_.outputs) {
      const auto size = static_cast<std::size_t>(action->raw.size());
      for (std::size_t i = 0; i < size; ++i, ++output) {
        const auto low = bound(contract.action_low, output, network_.outputs());
        const auto high = bound(contract.action_high, output, network_.outputs());
        const auto our_low = bound(action->raw.low, i, size);
        const auto our_high = bound(action->raw.high, i, size);
        if (!low || !high || !our_low || !our_high) continue;
        if (same(*low, *our_low) && same(*high, *our_high)) continue;
        auto& problem =
            error("E0705",
                  fmt::format("the policy `{}` was trained with actions from {:g} to {:g}, "
                              "but `{}{}` goes from {:g} to {:g}",
                              use_.file, *low, *high, use_.out, action->name, *our_low, *our_high));
        problem.notes.push_back(
            {use_.is_agent ? "the graph's action" : "the node's output", action->span, ""});
        problem.help = fmt::format(
            "give it the bounds of the training: `{}: {{{}: {{space: {{low: {:g}, high: "
            "{:g}}}}}}}`",
            use_.is_agent ? "actions" : "outputs", action->name, *low, *high);
        return;
      }
    }
  }

  /// "angle (2), theta_dot"
  static std::string listed(const std::vector<NamedPart>& parts) {
    std::vector<std::string> texts;
    texts.reserve(parts.size());
    for (const auto& part : parts) {
      texts.push_back(part.size == 1 ? part.name : fmt::format("{} ({})", part.name, part.size));
    }
    return fmt::format("{}", fmt::join(texts, ", "));
  }

  void check_observations() {
    const auto& theirs = network_.contract.observations;
    if (use_.inputs.empty()) return;
    if (theirs.empty()) return check_observation_bounds();
    std::vector<NamedPart> ours;
    for (const Input* input : use_.inputs)
      ours.push_back({input->name, input->window * input->space.size()});
    // Where each name starts and how long it is. Names that only one side has may be spelt
    // otherwise.
    const auto place =
        [](const std::vector<NamedPart>& parts,
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
    const std::string both =
        fmt::format("`{}` takes {}; the graph gives {}", use_.file, listed(theirs), listed(ours));
    if (!common) {
      auto& warning = diagnostics_.warning(
          "E0706", use_.span, "the policy's observations have other names than the graph's");
      warning.notes.push_back({both, use_.place, ""});
      warning.help =
          "so their order was not checked: give the observations the names of the training";
      return;
    }
    wrong_order(both).help = help_for_renamed(theirs, ours);
  }

  /// What to write so that the order is that of the training, as far as the names say it.
  std::string help_for_renamed(const std::vector<NamedPart>& theirs,
                               const std::vector<NamedPart>& ours) const {
    const auto order = order_of_training(theirs, ours);
    if (!order || order->renamed.empty()) return help_for_order("…");
    return fmt::format("rename {}; or {}", fmt::join(order->renamed, ", and "),
                       help_for_order(fmt::format("{}", fmt::join(order->names, ", "))));
  }

  std::string help_for_order(const std::string& order) const {
    return use_.is_agent
               ? fmt::format(
                     "write the order of the training: `agent: {{policy: …, observations: [{}]}}`",
                     order)
           : order == "…" ? "write the node's inputs in the order of the training"
                          : fmt::format(
                                "write the node's inputs in the order of the training: "
                                "`inputs: [{}]`",
                                order);
  }

  Diagnostic& wrong_order(const std::string& both) {
    auto& problem = error("E0706", "the policy's observations are not in the graph's order");
    problem.notes.push_back({both, use_.place, ""});
    problem.help = help_for_order("…");
    return problem;
  }

  struct BoundsOf {
    std::string name;  // "theta_dot", "angle[1]"
    float low, high;   // the file may hold them in float32
    bool operator<(const BoundsOf& other) const {
      return std::pair(low, high) < std::pair(other.low, other.high);
    }
  };

  /// Bounds of the graph's observations, one for each number; empty if one has none.
  std::vector<BoundsOf> our_bounds() const {
    std::vector<BoundsOf> result;
    for (const Input* input : use_.inputs) {
      const auto size = static_cast<std::size_t>(input->space.size());
      for (std::size_t i = 0; i < input->window * size; ++i) {
        const auto low = bound(input->space.low, i % size, size);
        const auto high = bound(input->space.high, i % size, size);
        if (!low || !high) return {};
        result.push_back({size == 1 ? input->name : fmt::format("{}[{}]", input->name, i % size),
                          static_cast<float>(*low), static_cast<float>(*high)});
      }
    }
    return result;
  }

  /// A file without names has bounds. Those of training may be others than the robot's; but the
  /// same ones at other places are another order.
  void check_observation_bounds() {
    const PolicyContract& contract = network_.contract;
    const std::vector<BoundsOf> ours = our_bounds();
    if (ours.size() != contract.observation_low.size() ||
        ours.size() != contract.observation_high.size()) {
      return;
    }
    std::vector<BoundsOf> theirs;
    for (std::size_t i = 0; i < ours.size(); ++i) {
      theirs.push_back({"", static_cast<float>(contract.observation_low[i]),
                        static_cast<float>(contract.observation_high[i])});
    }
    const auto equal = [](const BoundsOf& a, const BoundsOf& b) { return !(a < b) && !(b < a); };
    const auto first = std::mismatch(ours.begin(), ours.end(), theirs.begin(), equal);
    if (first.first == ours.end()) return;
    const BoundsOf here = *first.first;
    const BoundsOf there = *first.second;
    const auto index = first.first - ours.begin();
    auto sorted = ours;
    std::sort(sorted.begin(), sorted.end());
    std::sort(theirs.begin(), theirs.end());
    if (!std::equal(sorted.begin(), sorted.end(), theirs.begin(), equal)) return;
    wrong_order(
        fmt::format("observation {} of `{}` goes from {:g} to {:g}; the graph's is `{}`, "
                    "from {:g} to {:g}",
                    index, use_.file, there.low, there.high, here.name, here.low, here.high));
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
    if (network_.input_shape.size() < 2 || use_.inputs.size() != 1) return;
    const Input& input = *use_.inputs.front();
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
                                   "`{}{}` has [{}]",
                                   use_.file, fmt::join(network_.input_shape, ", "), use_.in,
                                   input.name, fmt::join(ours, ", ")));
    problem.notes.push_back({"the observation, its window first", input.span, ""});
    problem.help = "images are channels first, then rows, then columns";
  }

  /// Of a policy that does not fit, it is not asked for.
  void check_rate(bool fits) {
    const auto& in_file = network_.contract.rate_hz;
    const auto said = use_.trained_at ? std::optional(use_.trained_at->value.to_double())
                                      : std::optional<double>();
    if (in_file && said && !same(*in_file, *said)) {
      diagnostics_
          .error("E0707", use_.trained_at->span,
                 fmt::format("the policy `{}` was not trained at {:g} Hz: its file says {:g} Hz",
                             use_.file, *said, *in_file))
          .help = "leave `trained_at` out";
      return;
    }
    const auto rate = in_file ? in_file : said;
    const double ours = use_.rate_hz.to_double();
    if (!rate && fits) miss_rate();
    if (!rate) return;
    if (same(*rate, ours)) return;
    error("E0707", fmt::format("the policy `{}` was trained at {:g} Hz, but the {} runs at {:g} Hz",
                               use_.file, *rate, use_.is_agent ? "graph" : "node", ours))
        .help = fmt::format("set `rate: {:g}`, and let nodes run faster behind it", *rate);
  }

  void miss_rate() {
    auto& problem = diagnostics_.warning(
        "W0116", use_.span,
        fmt::format("nothing says at what rate the policy `{}` was trained", use_.file));
    problem.label = fmt::format("{} Hz here", use_.rate_hz.to_string());
    const std::string place = use_.is_agent ? "agent: {policy: …" : "policy: {file: …";
    problem.help =
        fmt::format("write the rate of the training: `{}, trained_at: {} Hz}}`, if it is that",
                    place, use_.rate_hz.to_string());
  }

  const PolicyUse& use_;
  const Network& network_;
  Diagnostics& diagnostics_;
};

}  // namespace

void check_policy_world(const PolicyUse& use, const Network& network, Diagnostics& diagnostics) {
  WorldCheck(use, network, diagnostics).run();
}

}  // namespace eagerx::gen
