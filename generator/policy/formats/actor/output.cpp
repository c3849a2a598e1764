// The output of an actor: its last activation and the form of its answers.
#include <fmt/core.h>

#include <utility>

#include "generator/policy/formats/actor/parts.hpp"

namespace eagerx::gen {
namespace {

class OutputReader : ActorParts {
 public:
  OutputReader(const ActorParts& parts, const ActorLayout& layout, const ReadContext& context)
      : ActorParts(parts), layout_(layout), context_(context) {}

  bool finish() {
    if (layout_.has_quantiles && !average_quantiles(*this)) {
      return false;
    }
    const auto output = choose_given_output() ? output_activation() : std::nullopt;
    if (!output) return false;
    if (*output != Activation::identity) {
      network.layers.back().activation = *output;
      network.layers.back().slope = default_slope(*output);
    }
    network.action = facts.action;
    if (network.action || layout_.output_rule == OutputRule::unknown) return true;
    // rl_games' `clip_actions` maps -1…1 to the bounds, and is not in its checkpoints.
    if (layout_.about == "Sample Factory") {
      network.assumed.push_back("no `obs_subtract_mean`, `obs_scale` and `continuous_tanh_scale`");
    }
    if (layout_.about == "rl_games" && layout_.action != ActionKind::argmax) {
      network.assumed.push_back(
          "actions are clipped to the bounds; with rl_games' `clip_actions` and bounds other than "
          "-1…1 say `output: squashed`");
      return true;
    }
    network.action = *output == Activation::tanh ? ActionKind::squashed : layout_.action;
    network.action_of = layout_.about;
    return true;
  }

 private:
  Refused says_nothing_of_its_output() {
    return fail("E0750", "does not say what follows its last layer",
                "say it in the graph: `agent: {policy: …, output_activation: tanh}`, or `none` if "
                "nothing does; for `policy` with `--output-activation tanh`");
  }

  /// Whether a tanh follows the last layer of a known library. Nothing, and a problem, if no source
  /// says so.
  std::optional<bool> is_squashed() {
    if (layout_.squash == Squash::never) return layout_.output == Activation::tanh;
    if (facts.squash) return facts.squash;
    if (layout_.squash == Squash::unless_linear && facts.action) {
      return *facts.action == ActionKind::squashed;
    }
    if (layout_.squash == Squash::if_said) return false;
    // One layer may be of ARS's LinearPolicy or of its MlpPolicy; only the latter has a tanh.
    if (layout_.modules.size() > 1) return true;
    if (table.find(layout_.modules.back().base + ".bias") == nullptr) return false;
    if (given_output_) return *given_output_ == Activation::tanh;
    says_nothing_of_its_output();
    return std::nullopt;
  }

  /// The activation after the last layer: as the file says, else as its library does, else as the
  /// graph says.
  std::optional<Activation> output_activation() {
    if (layout_.output_rule != OutputRule::fixed) {
      if (given_output_) return given_output_;
      if (layout_.output_rule == OutputRule::unknown) {
        // A file with `squash: False` says that its actions come out as they are.
        if (facts.action && *facts.action != ActionKind::squashed) return Activation::identity;
        return says_nothing_of_its_output();
      }
      network.assumed.push_back(fmt::format(
          "nothing after the last layer, which is {}'s unless it was changed", layout_.about));
      return layout_.output;
    }
    const auto squashes = is_squashed();
    if (!squashes) return std::nullopt;
    const bool adds_tanh = *squashes && !(facts.action && is_choice(*facts.action));
    const Activation output = adds_tanh ? Activation::tanh : Activation::identity;
    if (given_output_ && *given_output_ != output) {
      return fail("E0626",
                  fmt::format("is {}, after whose last layer comes {}, but the graph says {}",
                              layout_.about, output_name(output), output_name(*given_output_)),
                  "leave the graph's `output_activation` out");
    }
    return output;
  }
  static const char* output_name(Activation activation) {
    return activation == Activation::identity ? "nothing" : to_string(activation);
  }

  bool choose_given_output() {
    if (facts.output_activation && context_.output_activation &&
        *facts.output_activation != *context_.output_activation) {
      return fail("E0626",
                  fmt::format("says that {} follows its last layer, but the graph says {}",
                              output_name(*facts.output_activation),
                              output_name(*context_.output_activation)),
                  "leave the graph's `output_activation` out");
    }
    given_output_ = facts.output_activation ? facts.output_activation : context_.output_activation;
    return true;
  }

  const ActorLayout& layout_;
  const ReadContext& context_;
  std::optional<Activation> given_output_;
};

}  // namespace

bool finish_output(const ActorParts& parts, const ActorLayout& layout, const ReadContext& context) {
  if (parts.network.layers.empty()) {
    return parts.fail("E0624", "has an actor without layers");
  }
  return OutputReader(parts, layout, context).finish();
}

}  // namespace eagerx::gen
