#include "generator/policy/formats/actor/actor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "generator/policy/formats/actor/parts.hpp"
#include "generator/policy/network/limits.hpp"
#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

class Assembly {
 public:
  Assembly(const TensorTable& table, const PolicyFacts& facts, const ReadContext& context,
           PolicyProblem& problem)
      : table_(table), facts_(facts), context_(context), problem_(problem) {}

  std::optional<Network> run() {
    if (!check_supported()) return std::nullopt;
    auto layout = context_.layers.empty() ? find_actor(table_, is_zip(), problem_) : say_layout();
    if (!layout) return std::nullopt;
    layout_ = std::move(*layout);
    if (!add_memory(table_, layout_, problem_)) return std::nullopt;
    if (!check_algorithm() || !choose_activation() || !add_observation()) return std::nullopt;
    if (!add_modules(parts_, layout_, activation_) || !finish_output(parts_, layout_, context_) ||
        !check_facts()) {
      return std::nullopt;
    }
    network_.format = fmt::format("{}, {}", facts_.format, layout_.about);
    network_.contract = facts_.contract;
    if (!add_statistics(parts_) || !add_scaled_bounds(parts_) || !check_rest(parts_, layout_)) {
      return std::nullopt;
    }
    return std::move(network_);
  }

 private:
  /// The layout that the graph says, with what follows its last layer.
  std::optional<ActorLayout> say_layout() {
    std::optional<Activation> output;
    auto layout = said_layout(table_, context_.layers, output, problem_);
    if (!layout || !output) return layout;
    if (context_.output_activation && *context_.output_activation != *output) {
      return parts_.fail("E0626",
                         "has layers in the graph that end in another activation than "
                         "the graph's `output_activation`",
                         "leave `output_activation` out");
    }
    context_.output_activation = output;
    return layout;
  }

  /// Parts that would silently be left out, and change the function.
  bool check_supported() {
    if (facts_.unsupported) {
      return parts_.fail("E0628", *facts_.unsupported,
                         "export the actor to ONNX, or train without it");
    }
    const std::string known = " FlattenExtractor NatureCNN CombinedExtractor ";
    if (facts_.extractor && known.find(" " + *facts_.extractor + " ") == std::string::npos) {
      return parts_.fail(
          "E0628",
          fmt::format("has a custom features extractor (`{}`)", printable(*facts_.extractor)),
          "export the actor to ONNX");
    }
    return check_class();
  }

  /// A policy class of the user's own: only its answers show what it calculates.
  bool check_class() {
    if (!facts_.own_class || !context_.layers.empty()) return true;
    const std::string name = printable(*facts_.own_class);
    if (context_.has_answers) {
      network_.assumed.push_back(
          fmt::format("its own policy class `{}` calculates what the library's does, as far as the "
                      "known answers show",
                      name));
      return true;
    }
    constexpr std::size_t kMostShown = 4;
    std::vector<std::string> methods;
    for (const std::string& method : facts_.own_methods) {
      if (methods.size() < kMostShown) methods.push_back(fmt::format("`{}`", printable(method)));
    }
    return parts_.fail(
        "E0628",
        fmt::format("has a custom policy class (`{}`{}{}{})", name,
                    methods.empty() ? "" : ", which overrides ", join(methods, ", "),
                    methods.size() < facts_.own_methods.size() ? ", …" : ""),
        "export the actor to ONNX; if it calculates what the library's policy does, give known "
        "answers, and its activation: `agent: {policy: …, golden: rows.csv, activation: relu}`; "
        "for `policy test` with `--activation relu`");
  }

  /// Pixels become numbers from 0 to 1, and features if there is a network for them.
  bool add_observation() {
    if (facts_.scales_pixels && facts_.observations) {
      if (*facts_.observations > kMaxValues) {
        return parts_.fail("E0619", fmt::format("takes images of more than {} values", kMaxValues),
                           "use smaller images");
      }
      const auto count = static_cast<std::uint32_t>(*facts_.observations);
      Layer layer = layer_of(Elementwise{Elementwise::Operation::divide}, count, count, {255.0F});
      network_.layers.push_back(std::move(layer));
    }
    if (!add_one_hot(parts_)) return false;
    const auto first = table_.tensors.lower_bound(layout_.extractor + "cnn.");
    const bool has_cnn = !layout_.extractor.empty() && first != table_.tensors.end() &&
                         first->first.starts_with(layout_.extractor + "cnn.");
    if (has_cnn && !add_nature_cnn(parts_, layout_.extractor)) {
      return false;
    }
    features_ = network_.layers.size();
    return true;
  }

  bool is_zip() const { return facts_.format.starts_with("Stable-Baselines3"); }

  bool check_algorithm() {
    const std::string& said = facts_.contract.algorithm;
    if (said.empty() || layout_.algorithms.empty()) return true;
    const std::string known = fmt::format(" {} ", layout_.algorithms);
    if (known.find(" " + said + " ") != std::string::npos) return true;
    return parts_.fail("E0626",
                       fmt::format("says that it is of {}, but its tensors are those of {}",
                                   printable(said), layout_.about));
  }

  bool choose_activation() {
    // A zip of SB3 that names none has its class's.
    const bool is_usual = is_zip() && !facts_.own_class;
    const auto in_file = facts_.own_class                 ? std::nullopt
                         : facts_.activation || !is_usual ? facts_.activation
                                                          : layout_.activation;
    if (context_.activation && in_file && *context_.activation != *in_file) {
      return parts_.fail("E0626",
                         fmt::format("says that its activation is {}, but the graph says {}",
                                     to_string(*in_file), to_string(*context_.activation)),
                         "leave the graph's `activation` out");
    }
    const bool needed = std::any_of(
        layout_.modules.begin(), layout_.modules.end(),
        [](const ActorModule& module) { return module.activation_after && !module.activation; });
    auto said = in_file ? in_file : context_.activation;
    // The zip file contains the activation that the class was given.
    if (!said && facts_.own_class) said = facts_.activation;
    if (!said && !layout_.activation && needed) {
      const bool both = layout_.output_rule == OutputRule::unknown && !context_.output_activation;
      return parts_.fail(
          "E0629", "does not say which activation follows its hidden layers",
          both ? "say it in the graph, and what follows the last layer: `agent: {policy: …, "
                 "activation: elu, output_activation: none}`; for `policy` with "
                 "`--activation elu --output-activation none`"
               : "say it in the graph: `agent: {policy: …, activation: elu}`; for `policy` "
                 "with `--activation elu`");
    }
    activation_ = said ? *said : layout_.activation.value_or(Activation::identity);
    if (!said && needed) {
      network_.assumed.push_back(
          fmt::format("activation {}, which is {}'s unless it was "
                      "changed",
                      to_string(activation_), layout_.about));
    }
    return true;
  }

  bool check_facts() {
    std::vector<std::int64_t> hidden;
    for (std::size_t i = features_; i < network_.layers.size(); ++i) {
      if (network_.layers[i].is_dense()) hidden.push_back(network_.layers[i].outputs);
    }
    if (hidden.empty()) return parts_.fail("E0624", "has an actor without layers");
    hidden.pop_back();
    if (facts_.hidden && *facts_.hidden != hidden) {
      return parts_.fail("E0626",
                         fmt::format("says that its hidden layers are {}, but its tensors are {}",
                                     show(*facts_.hidden), show(hidden)));
    }
    if (facts_.observations && *facts_.observations != network_.inputs()) {
      return parts_.fail("E0626",
                         fmt::format("says that it takes {}, but its first layer takes {}",
                                     counted(*facts_.observations, "number"), network_.inputs()));
    }
    if (facts_.actions && *facts_.actions != network_.outputs()) {
      return parts_.fail("E0626",
                         fmt::format("says that it gives {}, but its last layer gives {}",
                                     counted(*facts_.actions, "number"), network_.outputs()));
    }
    return true;
  }

  const TensorTable& table_;
  const PolicyFacts& facts_;
  ReadContext context_;
  PolicyProblem& problem_;
  ActorLayout layout_;
  Activation activation_ = Activation::identity;
  Network network_;
  std::size_t features_ = 0;  // layers in front of the modules
  std::set<std::string> used_;
  const ActorParts parts_{table_, facts_, network_, used_, problem_};
};

}  // namespace

std::optional<Network> make_actor(const TensorTable& table, const PolicyFacts& facts,
                                  const ReadContext& context, PolicyProblem& problem) {
  return Assembly(table, facts, context, problem).run();
}

}  // namespace eagerx::gen
