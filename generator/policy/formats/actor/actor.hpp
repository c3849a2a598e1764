// Builds the actor's layers from named tensors: finds the actor's names, adds the operations that
// its library puts between them, and checks the rest of the file.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/policy/formats/common/read_context.hpp"
#include "generator/policy/formats/tensors/tensor.hpp"
#include "generator/policy/network/network.hpp"
#include "generator/policy/network/problem.hpp"

namespace eagerx::gen {

/// Whether a module or tensor belongs to a critic, which has no part in the action.
bool is_critic(std::string_view name);

/// Facts in a file other than its tensors.
struct PolicyFacts {
  std::string format;
  std::optional<Activation> activation;         // of hidden layers
  std::optional<Activation> output_activation;  // after the last layer
  std::optional<ActionKind> action;
  std::optional<std::vector<std::int64_t>> hidden;    // outputs of the hidden layers
  std::optional<std::int64_t> observations, actions;  // how many numbers
  std::optional<double> clip, epsilon;                // of the statistics
  std::optional<std::string> unsupported;             // why it cannot be read at all
  std::optional<std::string> extractor;               // class of its features extractor
  std::optional<std::string> own_class;  // of its policy, if no library has it: "my.module.Name"
  std::vector<std::string> own_methods;  // that this class has itself
  std::optional<Dims> image;             // of the observation: [channels, rows, columns]
  bool scales_pixels = false;            // by 1 / 255
  std::optional<bool> squash;            // whether a tanh follows the mean
  double norm_epsilon = 1e-3;            // of CrossQ's batch norms; sb3-contrib's default
  double limit = 2.0;                    // of the mean, where the layout has one
  PolicyContract contract;
};

/// The facts in the metadata of a safetensors file (keys: algo, activation, obs, low, high, squash,
/// clip_obs, epsilon, rate, output_activation), and arrays of one number with those names. E0626
/// for values that cannot be read.
std::optional<PolicyFacts> facts_of_notes(const TensorTable& table, PolicyProblem& problem);

/// The facts in `data` of a Stable-Baselines3 archive. E0626.
std::optional<PolicyFacts> facts_of_sb3(std::string_view json, PolicyProblem& problem);

/// The actor. E0624: no actor found, or a part of it is missing; E0625: several found; E0626:
/// tensors and facts disagree; E0628: it has unsupported parts; E0629: its activation is unknown;
/// E0750: the function after its last layer is unknown; E0627: its statistics do not fit.
std::optional<Network> make_actor(const TensorTable& table, const PolicyFacts& facts,
                                  const ReadContext& context, PolicyProblem& problem);

/// E0627 for NaN, a variance below zero, a clip that is not above it. An infinite clip becomes the
/// largest number.
bool check_statistics(Normalization& statistics, PolicyProblem& problem);

/// Whether a tanh follows the last layer, in addition to `KnownLayout::output`.
enum class Squash : std::uint8_t {
  never,
  if_said,        // PolicyFacts::squash
  unless_linear,  // sb3-contrib's ARS: its LinearPolicy, one layer, has none
};

/// Where a library puts its GRU or LSTM if the sizes fit in several places.
enum class MemoryPlace : std::uint8_t { unknown, first, before_head };

/// The source of the activation after the last layer.
enum class OutputRule : std::uint8_t {
  unknown,  // no source: the graph must say it
  usual,    // the library's default, which its users may have changed
  fixed,    // the library: there is no other
};

/// One of an actor, in the order of evaluation.
struct ActorModule {
  std::string base;  // "actor.latent_pi.0"
  bool activation_after = false;
  std::optional<int> recurrent{};          // layer of a GRU or LSTM: base.weight_ih_l0
  bool is_limited = false;                 // by PolicyFacts::limit
  std::optional<Activation> activation{};  // its own, if the graph says one
};

/// `bodies` are followed by an activation each, then comes `head`: a layer or a sequence.
struct KnownLayout {
  std::string_view about;            // "Stable-Baselines3's SAC"
  std::string_view algorithms = {};  // "SAC TQC", empty: any
  std::array<const char*, 2> bodies = {};
  const char* head = nullptr;
  bool head_is_sequence = false;
  std::array<const char*, 2> must_have =
      {};  // names that start like one of these tell layouts apart
  const char* must_not_have = nullptr;
  /// Names, or with a dot at their end beginnings of names, one of which a file without its zip
  /// must have to be of this library. None: `must_have` is enough.
  std::array<const char*, 5> marks = {};
  ActionKind action = ActionKind::raw;
  std::optional<Activation> activation = std::nullopt;  // if nothing else is said
  Activation output = Activation::identity;             // after the last layer
  bool has_bias = false;                                // always
  std::string_view memory = {};                         // a GRU or LSTM before the bodies
  MemoryPlace memory_place = MemoryPlace::unknown;
  std::array<const char*, 2> extractors = {};  // the first that is there
  Squash squash = Squash::never;
  bool has_quantiles = false;
  OutputRule output_rule = OutputRule::fixed;
  bool is_alone = false;  // the file has one tensor
  bool is_list = false;   // of layers, with an activation after each but the last
};

/// An actor that was found: as its library has it, or a torch module.
struct ActorLayout : KnownLayout {
  std::vector<ActorModule> modules{};
  std::string extractor{};  // what names in front of the modules start with
  bool is_said = false;     // by the graph: what it leaves out is not used
};

/// The only actor among the names. A file that is not a Stable-Baselines3 `zip` is assigned to a
/// library only if it has unique marks. E0624, E0625.
std::optional<ActorLayout> find_actor(const TensorTable& table, bool is_zip,
                                      PolicyProblem& problem);

/// The layers that the graph lists, in its order. Sets `output` to the activation that it gives for
/// the last one. E0624, E0626.
std::optional<ActorLayout> said_layout(const TensorTable& table,
                                       const std::vector<std::string>& layers,
                                       std::optional<Activation>& output, PolicyProblem& problem);

/// The order of layers by their sizes, if their names have no order: each layer's input size is the
/// output size of the one before. Empty if there is no such order, or if the names have one.
std::vector<std::string> order_by_sizes(const TensorTable& table);

/// Whether a tensor that nothing has read is for training only.
bool is_for_training(std::string_view name);

/// Puts the layers of a GRU or LSTM into `layout`: those of `layout.memory`, else the only one
/// there is, where its sizes fit. E0624, E0625.
bool add_memory(const TensorTable& table, ActorLayout& layout, PolicyProblem& problem);

/// Layer `index` of the GRU or LSTM `base`. E0618, E0628 and those of `floats_of`.
std::optional<Layer> recurrent_layer(const TensorTable& table, const std::string& base, int index,
                                     std::vector<std::string>& used, PolicyProblem& problem);

}  // namespace eagerx::gen
