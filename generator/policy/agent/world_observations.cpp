// Compares the graph's observations with those of a policy's training.
#include <fmt/format.h>

#include <algorithm>

#include "generator/policy/agent/order.hpp"
#include "generator/policy/agent/world_checks.hpp"
#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

class ObservationCheck {
 public:
  ObservationCheck(const PolicyUse& use, const Network& network, Diagnostics& diagnostics)
      : use_(use), network_(network), diagnostics_(diagnostics) {}

  void run() {
    check_observations();
    check_shape();
  }

 private:
  Diagnostic& error(const char* code, const std::string& message) {
    return diagnostics_.error(code, use_.span, message);
  }

  /// "angle (2), theta_dot"
  static std::string listed(const std::vector<NamedPart>& parts) {
    std::vector<std::string> texts;
    texts.reserve(parts.size());
    for (const auto& part : parts) {
      texts.push_back(part.size == 1 ? part.name : fmt::format("{} ({})", part.name, part.size));
    }
    return fmt::format("{}", join(texts, ", "));
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

  /// Help that gives the order of the training, as far as the names tell it.
  std::string help_for_renamed(const std::vector<NamedPart>& theirs,
                               const std::vector<NamedPart>& ours) const {
    const auto order = order_of_training(theirs, ours);
    if (!order || order->renamed.empty()) return help_for_order("…");
    return fmt::format("rename {}; or {}", join(order->renamed, ", and "),
                       help_for_order(fmt::format("{}", join(order->names, ", "))));
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
        const auto low = bound_of(input->space.low, i % size, size);
        const auto high = bound_of(input->space.high, i % size, size);
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
                                   use_.file, join(network_.input_shape, ", "), use_.in, input.name,
                                   join(ours, ", ")));
    problem.notes.push_back({"the observation, its window first", input.span, ""});
    problem.help = "images are channels first, then rows, then columns";
  }

  const PolicyUse& use_;
  const Network& network_;
  Diagnostics& diagnostics_;
};

}  // namespace

void check_policy_observations(const PolicyUse& use, const Network& network,
                               Diagnostics& diagnostics) {
  ObservationCheck(use, network, diagnostics).run();
}

}  // namespace eagerx::gen
