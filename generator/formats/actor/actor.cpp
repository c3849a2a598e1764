#include "generator/formats/actor/actor.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "generator/formats/actor/parts.hpp"
#include "generator/network/limits.hpp"

namespace eagerx::gen {
namespace {

class Assembly {
 public:
  Assembly(const TensorTable& table, const PolicyFacts& facts, const ReadContext& context,
           PolicyProblem& problem)
      : table_(table), facts_(facts), context_(context), problem_(problem) {}

  std::optional<Network> run() {
    if (!check_supported()) return std::nullopt;
    auto layout = find_actor(table_, is_zip(), problem_);
    if (!layout) return std::nullopt;
    layout_ = std::move(*layout);
    if (!add_memory(table_, layout_, problem_)) return std::nullopt;
    if (!check_algorithm() || !choose_activation() || !add_observation()) return std::nullopt;
    for (const ActorModule& module : layout_.modules) {
      if (!add(module) || !check_size()) return std::nullopt;
    }
    if (!finish_layers() || !check_facts()) return std::nullopt;
    network_.format = fmt::format("{}, {}", facts_.format, layout_.about);
    network_.contract = facts_.contract;
    const ActorParts parts{table_, facts_, network_, used_, problem_};
    if (!add_statistics(parts) || !add_scaled_bounds(parts) || !check_rest()) return std::nullopt;
    for (const auto& [name, tensor] : table_.tensors) {
      if (used_.count(name) > 0) continue;
      network_.ignored.push_back(
          fmt::format("tensor `{}` {}", printable(name), show(tensor.shape)));
    }
    return std::move(network_);
  }

 private:
  bool fail(const char* code, std::string message, std::string help = kOtherActor) {
    problem_ = {code, std::move(message), std::move(help)};
    return false;
  }

  /// Parts that would silently be left out, and change the function.
  bool check_supported() {
    if (facts_.unsupported) {
      return fail("E0628", *facts_.unsupported, "export the actor to ONNX, or train without it");
    }
    const std::string known = " FlattenExtractor NatureCNN CombinedExtractor ";
    if (facts_.extractor && known.find(" " + *facts_.extractor + " ") == std::string::npos) {
      return fail(
          "E0628",
          fmt::format("has a features extractor of its own (`{}`)", printable(*facts_.extractor)),
          "export the actor to ONNX");
    }
    return true;
  }

  /// Whether a tensor that nothing has read is for training only.
  bool may_be_left(std::string_view name) const {
    const auto has = [&](std::string_view part) { return name.find(part) != name.npos; };
    constexpr std::array kParts = {"critic",
                                   "value",
                                   "vf_",
                                   "target",
                                   "logstd",
                                   "sigma",
                                   "rnd.",
                                   "num_batches_tracked",
                                   "ret_rms",
                                   "discriminator",
                                   ".steps",
                                   "memory_c",
                                   ".c_rnn",
                                   ".c_layer_norm",
                                   "_disc_mlp",
                                   "_disc_logits",
                                   "returns_normalizer"};
    if (std::any_of(kParts.begin(), kParts.end(), has)) return true;
    if (has("std") && !has("obs") && !has("norm") && !has("mean")) return true;
    constexpr std::array kNotes = {"low",      "high",  "rate",  "squash",
                                   "clip_obs", "gamma", "count", "epsilon"};
    if (std::find(kNotes.begin(), kNotes.end(), name) != kNotes.end()) return true;
    // PPO's extractor is there under several names; skrl's critic may see more than its actor.
    const bool again = !layout_.extractor.empty() && !network_.input_shape.empty() &&
                       name.starts_with("features_extractor.");
    return again || (name.starts_with("state_preprocessor.") &&
                     table_.find("observation_preprocessor.running_mean") != nullptr);
  }

  /// What nobody has read may stand between observation and action: it is not left out silently.
  bool check_rest() {
    for (const auto& [name, tensor] : table_.tensors) {
      if (used_.count(name) > 0 || may_be_left(name)) continue;
      return fail("E0628", fmt::format("has parts that are not supported: `{}`", printable(name)),
                  "layers are Linear, LayerNorm, BatchNorm, GRU, LSTM and NatureCNN; give "
                  "statistics as `normalize`, or export the actor to ONNX");
    }
    return true;
  }

  /// Pixels become numbers from 0 to 1, and features if there is a network for them.
  bool add_observation() {
    if (facts_.scales_pixels && facts_.observations) {
      if (*facts_.observations > kMaxValues) {
        return fail("E0619", fmt::format("takes images of more than {} values", kMaxValues),
                    "use smaller images");
      }
      Layer layer;
      layer.inputs = layer.outputs = static_cast<std::uint32_t>(*facts_.observations);
      layer.form = Elementwise{Elementwise::Operation::divide};
      layer.bias = {255.0F};
      network_.layers.push_back(std::move(layer));
    }
    if (!add_one_hot({table_, facts_, network_, used_, problem_})) return false;
    const auto first = table_.tensors.lower_bound(layout_.extractor + "cnn.");
    const bool has_cnn = !layout_.extractor.empty() && first != table_.tensors.end() &&
                         first->first.starts_with(layout_.extractor + "cnn.");
    if (has_cnn &&
        !add_nature_cnn({table_, facts_, network_, used_, problem_}, layout_.extractor)) {
      return false;
    }
    features_ = network_.layers.size();
    return true;
  }

  bool is_zip() const { return facts_.format.starts_with("Stable-Baselines3"); }

  bool check_algorithm() {
    const std::string& said = facts_.contract.algorithm;
    if (said.empty() || layout_.algorithms.empty()) return true;
    const std::string known = " " + layout_.algorithms + " ";
    if (known.find(" " + said + " ") != std::string::npos) return true;
    return fail("E0626", fmt::format("says that it is of {}, but its tensors are those of {}",
                                     printable(said), layout_.about));
  }

  bool choose_activation() {
    // A zip of SB3 that names none has its class's.
    const auto in_file = facts_.activation || !is_zip() ? facts_.activation : layout_.activation;
    if (context_.activation && in_file && *context_.activation != *in_file) {
      return fail("E0626",
                  fmt::format("says that its activation is {}, but the graph says {}",
                              to_string(*in_file), to_string(*context_.activation)),
                  "leave the graph's `activation` out");
    }
    const bool needed =
        std::any_of(layout_.modules.begin(), layout_.modules.end(),
                    [](const ActorModule& module) { return module.activation_after; });
    const auto said = in_file ? in_file : context_.activation;
    if (!said && !layout_.activation && needed) {
      const bool both = layout_.output_rule == OutputRule::unknown && !context_.output_activation;
      return fail("E0629", "does not say which activation follows its hidden layers",
                  both
                      ? "say it in the graph, and what follows the last layer: `agent: {policy: …, "
                        "activation: elu, output_activation: none}`; for `policy` with "
                        "`--activation elu --output-activation none`"
                      : "say it in the graph: `agent: {policy: …, activation: elu}`; for `policy` "
                        "with `--activation elu`");
    }
    activation_ = said ? *said : layout_.activation.value_or(Activation::identity);
    if (!said && needed) {
      network_.assumed.push_back(
          fmt::format("activation {}, which is {}'s unless it was told "
                      "otherwise",
                      to_string(activation_), layout_.about));
    }
    return true;
  }

  bool add_recurrent(const ActorModule& module) {
    std::vector<std::string> names;
    auto layer = recurrent_layer(table_, module.base, *module.recurrent, names, problem_);
    if (!layer) return false;
    if (!network_.layers.empty() && network_.outputs() != layer->inputs) {
      return fail("E0618", fmt::format("gives {} values to its memory `{}`, which takes {}",
                                       network_.outputs(), printable(module.base), layer->inputs));
    }
    used_.insert(names.begin(), names.end());
    network_.layers.push_back(std::move(*layer));
    return true;
  }

  /// Many layers may be made of the same bytes.
  bool check_size() {
    std::size_t parameters = 0;
    for (const Layer& layer : network_.layers) {
      parameters += layer.weights.size() + layer.bias.size();
      if (layer.recurrence() != nullptr) parameters += layer.recurrence()->hidden_weights.size();
    }
    return parameters <= static_cast<std::size_t>(kMaxParameters) ||
           fail("E0619", fmt::format("has more than {} parameters", kMaxParameters),
                "use a smaller network");
  }

  bool add(const ActorModule& module) {
    if (network_.layers.size() >= kMaxLayers) {
      return fail("E0619", fmt::format("has more than {} layers", kMaxLayers));
    }
    if (module.recurrent) return add_recurrent(module);
    if (is_batch_norm(table_, module.base)) {
      if (!add_batch_norm({table_, facts_, network_, used_, problem_}, module.base)) return false;
      return activate(module);
    }
    const StoredTensor* weight = table_.find(module.base + ".weight");
    if (weight == nullptr) return missing(module.base + ".weight");
    const bool added = weight->shape.size() == 1 ? add_norm(module.base, *weight)
                                                 : add_dense(module.base, *weight);
    if (!added) return false;
    if (module.is_limited && facts_.limit > 0.0) {
      add_limits(network_, static_cast<float>(facts_.limit));
    }
    return activate(module);
  }
  bool activate(const ActorModule& module) {
    if (module.activation_after) {
      network_.layers.back().activation = activation_;
      network_.layers.back().slope = default_slope(activation_);
    }
    return true;
  }
  bool missing(const std::string& name) {
    return fail("E0624", fmt::format("has an actor without tensor `{}`", printable(name)));
  }

  /// The bias of `base` with `count` values; nothing if there is none or a problem.
  std::optional<std::vector<float>> bias_of(const std::string& base, std::int64_t count,
                                            bool required) {
    const std::string name = base + ".bias";
    const StoredTensor* bias = table_.find(name);
    if (bias == nullptr) {
      if (!required) return std::vector<float>(static_cast<std::size_t>(count), 0.0F);
      missing(name);
      return std::nullopt;
    }
    if (bias->shape != Dims{count}) {
      return refuse(problem_, "E0618",
                    fmt::format("has tensor `{}` of shape {} for {} outputs", printable(name),
                                show(bias->shape), count),
                    kOtherActor);
    }
    used_.insert(name);
    return floats_of(name, *bias, problem_);
  }

  bool add_dense(const std::string& base, const StoredTensor& weight) {
    const std::string name = base + ".weight";
    if (weight.shape.size() != 2 || weight.shape[0] < 1 || weight.shape[1] < 1) {
      return fail("E0628",
                  fmt::format("has tensor `{}` of shape {}", printable(name), show(weight.shape)),
                  "layers are Linear, with a matrix, and LayerNorm");
    }
    const std::int64_t outputs = weight.shape[0];
    const std::int64_t inputs = weight.shape[1];
    if (!network_.layers.empty() && network_.outputs() != inputs) {
      return fail("E0618",
                  fmt::format("multiplies {} values by tensor `{}`, which takes {}",
                              network_.outputs(), printable(name), inputs),
                  kOtherActor);
    }
    auto weights = floats_of(name, weight, problem_);
    if (!weights) return false;
    auto bias = bias_of(base, outputs, layout_.has_bias);
    if (!bias) return false;
    used_.insert(name);
    Layer layer;
    layer.inputs = static_cast<std::uint32_t>(inputs);
    layer.outputs = static_cast<std::uint32_t>(outputs);
    layer.weights = std::move(*weights);
    layer.bias = std::move(*bias);
    network_.layers.push_back(std::move(layer));
    return true;
  }

  bool add_norm(const std::string& base, const StoredTensor& weight) {
    const std::string name = base + ".weight";
    Layer* layer = network_.layers.empty() ? nullptr : &network_.layers.back();
    if (layer == nullptr || !layer->is_dense() || layer->norm ||
        layer->activation != Activation::identity) {
      return fail("E0628",
                  fmt::format("has a LayerNorm that does not directly follow a Linear: `{}`",
                              printable(name)),
                  "put the LayerNorm between Linear and activation");
    }
    if (weight.shape != Dims{std::int64_t{layer->outputs}}) {
      return fail("E0618", fmt::format("has tensor `{}` of shape {} for {} values", printable(name),
                                       show(weight.shape), layer->outputs));
    }
    if (table_.find(base + ".bias") == nullptr) {
      return fail("E0628",
                  fmt::format("has a norm without a bias, which may be a LayerNorm or an RMSNorm: "
                              "`{}`",
                              printable(name)),
                  "export the actor to ONNX");
    }
    auto gamma = floats_of(name, weight, problem_);
    if (!gamma) return false;
    auto beta = bias_of(base, layer->outputs, true);
    if (!beta) return false;
    used_.insert(name);
    layer->norm = LayerNorm{std::move(*gamma), std::move(*beta)};
    return true;
  }

  bool says_nothing_of_its_output() {
    return fail("E0750", "does not say what follows its last layer",
                "say it in the graph: `agent: {policy: …, output_activation: tanh}`, or `none` if "
                "nothing does; for `policy` with `--output-activation tanh`");
  }

  /// Whether a tanh follows the last layer of a known library. Nothing, and a problem, if nobody
  /// says so.
  std::optional<bool> is_squashed() {
    if (layout_.squash == Squash::never) return layout_.output == Activation::tanh;
    if (facts_.squash) return facts_.squash;
    if (layout_.squash == Squash::unless_linear && facts_.action) {
      return *facts_.action == ActionKind::squashed;
    }
    if (layout_.squash == Squash::if_said) return false;
    // One layer may be of ARS's LinearPolicy or of its MlpPolicy; only the latter has a tanh.
    if (layout_.modules.size() > 1) return true;
    if (table_.find(layout_.modules.back().base + ".bias") == nullptr) return false;
    if (told_output_) return *told_output_ == Activation::tanh;
    says_nothing_of_its_output();
    return std::nullopt;
  }

  /// What follows the last layer: as the file says, else as its library does, else as the graph
  /// says.
  std::optional<Activation> output_activation() {
    if (layout_.output_rule != OutputRule::fixed) {
      if (told_output_) return told_output_;
      if (layout_.output_rule == OutputRule::unknown) {
        // A file with `squash: False` says that its actions come out as they are.
        if (facts_.action && *facts_.action != ActionKind::squashed) return Activation::identity;
        says_nothing_of_its_output();
        return std::nullopt;
      }
      network_.assumed.push_back(
          fmt::format("nothing after the last layer, which is {}'s unless it was told otherwise",
                      layout_.about));
      return layout_.output;
    }
    const auto squashes = is_squashed();
    if (!squashes) return std::nullopt;
    const bool adds_tanh = *squashes && facts_.action != ActionKind::argmax;
    const Activation output = adds_tanh ? Activation::tanh : Activation::identity;
    if (told_output_ && *told_output_ != output) {
      fail("E0626",
           fmt::format("is {}, after whose last layer comes {}, but the graph says {}",
                       layout_.about, output_name(output), output_name(*told_output_)),
           "leave the graph's `output_activation` out");
      return std::nullopt;
    }
    return output;
  }
  static const char* output_name(Activation activation) {
    return activation == Activation::identity ? "nothing" : to_string(activation);
  }

  bool choose_told_output() {
    if (facts_.output_activation && context_.output_activation &&
        *facts_.output_activation != *context_.output_activation) {
      return fail("E0626",
                  fmt::format("says that {} follows its last layer, but the graph says {}",
                              output_name(*facts_.output_activation),
                              output_name(*context_.output_activation)),
                  "leave the graph's `output_activation` out");
    }
    told_output_ = facts_.output_activation ? facts_.output_activation : context_.output_activation;
    return true;
  }

  bool finish_layers() {
    if (network_.layers.empty()) return fail("E0624", "has an actor without layers");
    if (layout_.has_quantiles && !average_quantiles({table_, facts_, network_, used_, problem_})) {
      return false;
    }
    const auto output = choose_told_output() ? output_activation() : std::nullopt;
    if (!output) return false;
    if (*output != Activation::identity) {
      network_.layers.back().activation = *output;
      network_.layers.back().slope = default_slope(*output);
    }
    network_.action = facts_.action;
    if (network_.action || layout_.output_rule == OutputRule::unknown) return true;
    // rl_games' `clip_actions` maps -1…1 to the bounds, and is not in its checkpoints.
    if (layout_.about == "Sample Factory") {
      network_.assumed.push_back("no `obs_subtract_mean`, `obs_scale` and `continuous_tanh_scale`");
    }
    if (layout_.about == "rl_games" && layout_.action != ActionKind::argmax) {
      network_.assumed.push_back(
          "actions are clipped to the bounds; with rl_games' `clip_actions` and bounds other than "
          "-1…1 say `output: squashed`");
      return true;
    }
    network_.action = *output == Activation::tanh ? ActionKind::squashed : layout_.action;
    network_.action_of = layout_.about;
    return true;
  }

  bool check_facts() {
    std::vector<std::int64_t> hidden;
    for (std::size_t i = features_; i < network_.layers.size(); ++i) {
      if (network_.layers[i].is_dense()) hidden.push_back(network_.layers[i].outputs);
    }
    if (hidden.empty()) return fail("E0624", "has an actor without layers");
    hidden.pop_back();
    if (facts_.hidden && *facts_.hidden != hidden) {
      return fail("E0626", fmt::format("says that its hidden layers are {}, but its tensors are {}",
                                       show(*facts_.hidden), show(hidden)));
    }
    if (facts_.observations && *facts_.observations != network_.inputs()) {
      return fail("E0626",
                  fmt::format("says that it takes {} numbers, but its first layer takes {}",
                              *facts_.observations, network_.inputs()));
    }
    if (facts_.actions && *facts_.actions != network_.outputs()) {
      return fail("E0626", fmt::format("says that it gives {} numbers, but its last layer gives {}",
                                       *facts_.actions, network_.outputs()));
    }
    return true;
  }

  const TensorTable& table_;
  const PolicyFacts& facts_;
  const ReadContext& context_;
  PolicyProblem& problem_;
  ActorLayout layout_;
  Activation activation_ = Activation::identity;
  std::optional<Activation> told_output_;
  Network network_;
  std::size_t features_ = 0;  // layers in front of the modules
  std::set<std::string> used_;
};

}  // namespace

bool check_statistics(Normalization& statistics, PolicyProblem& problem) {
  const auto fail = [&](const char* how) {
    problem = {"E0627", fmt::format("has statistics {}", how), kOtherActor};
    return false;
  };
  if (statistics.mean.empty() || statistics.mean.size() != statistics.variance.size()) {
    return fail("with different numbers of means and variances");
  }
  for (std::size_t i = 0; i < statistics.mean.size(); ++i) {
    if (!std::isfinite(statistics.mean[i]) || !std::isfinite(statistics.variance[i])) {
      return fail("with NaN or infinity");
    }
    const double sum = statistics.variance[i] + statistics.epsilon;
    if (statistics.variance[i] < 0.0 || !(sum > 0.0)) return fail("with a variance below zero");
  }
  if (!(statistics.epsilon >= 0.0)) return fail("whose epsilon is below zero");
  if (!(statistics.clip > 0.0)) return fail("whose clip is not above zero");
  statistics.clip = std::min(statistics.clip, std::numeric_limits<double>::max());
  return true;
}

std::optional<Network> make_actor(const TensorTable& table, const PolicyFacts& facts,
                                  const ReadContext& context, PolicyProblem& problem) {
  return Assembly(table, facts, context, problem).run();
}

}  // namespace eagerx::gen
