// Actors of libraries, by the names of their tensors. Inside formats/actor only.
#pragma once

#include <array>
#include <optional>

#include "generator/formats/actor/actor.hpp"

namespace eagerx::gen {

/// `bodies` are followed by an activation each, then comes `head`: a layer or a sequence.
struct KnownLayout {
  const char* about;
  const char* algorithms = "";
  std::array<const char*, 2> bodies = {};
  const char* head;
  bool head_is_sequence = false;
  std::array<const char*, 2> must_have;  // names that start like one of these tell layouts apart
  const char* must_not_have = nullptr;
  /// Names, or with a dot at their end beginnings of names, one of which a file without its zip
  /// must have to be of this library. None: `must_have` is enough.
  std::array<const char*, 5> marks = {};
  ActionKind action = ActionKind::raw;
  std::optional<Activation> activation = std::nullopt;
  Activation output = Activation::identity;
  bool has_bias = false;
  const char* memory = "";  // a GRU or LSTM before the bodies
  MemoryPlace memory_place = MemoryPlace::unknown;
  std::array<const char*, 2> extractors = {};  // the first that is there
  Squash squash = Squash::never;
  bool has_quantiles = false;
  OutputRule output_rule = OutputRule::fixed;
  bool is_alone = false;  // the file has one tensor
  bool is_list = false;   // of layers, with an activation after each but the last
};
inline constexpr std::array kKnownLayouts = {
    KnownLayout{.about = "eagerx-gen train",
                .bodies = {"policy.hidden."},
                .head = "policy.action",
                .must_have = {"policy.hidden.", "policy.action.weight"},
                .action = ActionKind::squashed,
                .activation = Activation::tanh,
                .output = Activation::tanh,
                .has_bias = true},
    KnownLayout{.about = "Stable-Baselines3's SAC",
                .algorithms = "SAC TQC CROSSQ",
                .bodies = {"actor.latent_pi."},
                .head = "actor.mu",
                .must_have = {"actor.latent_pi.", "actor.mu.weight"},
                .action = ActionKind::squashed,
                .activation = Activation::relu,
                .output = Activation::tanh,
                .has_bias = true,
                .extractors = {"actor.features_extractor."}},
    KnownLayout{.about = "Stable-Baselines3's TD3",
                .algorithms = "TD3 DDPG",
                .head = "actor.mu.",
                .head_is_sequence = true,
                .must_have = {"actor.mu.0."},
                .must_not_have = "actor.latent_pi.",
                .marks = {"actor_target.", "critic.qf0.", "critic_target."},
                .action = ActionKind::squashed,
                .activation = Activation::relu,
                .output = Activation::tanh,
                .has_bias = true,
                .extractors = {"actor.features_extractor."}},
    KnownLayout{.about = "Stable-Baselines3's RecurrentPPO",
                .algorithms = "RecurrentPPO",
                .bodies = {"mlp_extractor.policy_net."},
                .head = "action_net",
                .must_have = {"lstm_actor."},
                .activation = Activation::tanh,
                .has_bias = true,
                .memory = "lstm_actor",
                .extractors = {"pi_features_extractor.", "features_extractor."},
                .squash = Squash::if_said},
    KnownLayout{.about = "Stable-Baselines3's PPO or A2C",
                .algorithms = "PPO A2C TRPO MaskablePPO",
                .bodies = {"mlp_extractor.shared_net.", "mlp_extractor.policy_net."},
                .head = "action_net",
                .must_have = {"action_net.weight", "mlp_extractor.policy_net."},
                .must_not_have = "lstm_actor.",
                .marks = {"mlp_extractor.", "value_net.", "log_std", "features_extractor."},
                .activation = Activation::tanh,
                .has_bias = true,
                .extractors = {"pi_features_extractor.", "features_extractor."},
                .squash = Squash::if_said},
    KnownLayout{.about = "sb3-contrib's ARS",
                .algorithms = "ARS",
                .head = "action_net.",
                .head_is_sequence = true,
                .must_have = {"action_net.0."},
                .marks = {""},  // its zip only
                .activation = Activation::relu,
                .extractors = {"features_extractor."},
                .squash = Squash::unless_linear},
    KnownLayout{.about = "sb3-contrib's ARS",  // its LinearPolicy before 2.0
                .algorithms = "ARS",
                .head = "action_net",
                .must_have = {"action_net.weight"},
                .marks = {""},  // its zip only
                .activation = Activation::relu,
                .is_alone = true},
    KnownLayout{.about = "Stable-Baselines3's DQN",
                .algorithms = "DQN",
                .head = "q_net.q_net.",
                .head_is_sequence = true,
                .must_have = {"q_net.q_net."},
                .action = ActionKind::argmax,
                .activation = Activation::relu,
                .has_bias = true,
                .extractors = {"q_net.features_extractor."}},
    KnownLayout{.about = "sb3-contrib's QR-DQN",
                .algorithms = "QRDQN",
                .head = "quantile_net.quantile_net.",
                .head_is_sequence = true,
                .must_have = {"quantile_net.quantile_net."},
                .action = ActionKind::argmax,
                .activation = Activation::relu,
                .has_bias = true,
                .extractors = {"quantile_net.features_extractor."},
                .has_quantiles = true},
    KnownLayout{.about = "rl_games",
                .bodies = {"a2c_network.actor_mlp."},
                .head = "a2c_network.mu",
                .must_have = {"a2c_network.actor_mlp."},
                .must_not_have = "a2c_network.logits.",
                .memory_place = MemoryPlace::before_head,
                .output_rule = OutputRule::usual},
    KnownLayout{.about = "rl_games",
                .bodies = {"a2c_network.actor_mlp."},
                .head = "a2c_network.logits",
                .must_have = {"a2c_network.logits."},
                .action = ActionKind::argmax,
                .memory_place = MemoryPlace::before_head},
    KnownLayout{.about = "Sample Factory",
                .bodies = {"encoder.encoders.obs.mlp_head.", "decoder.mlp."},
                .head = "action_parameterization.distribution_linear",
                .must_have = {"encoder.encoders.obs.mlp_head."},
                .activation = Activation::elu,
                .memory_place = MemoryPlace::before_head,
                .output_rule = OutputRule::usual},
    KnownLayout{.about = "Sample Factory",  // actor_critic_share_weights=False
                .bodies = {"actor_encoder.encoders.obs.mlp_head.", "actor_decoder.mlp."},
                .head = "action_parameterization.distribution_linear",
                .must_have = {"actor_encoder.encoders.obs.mlp_head."},
                .activation = Activation::elu,
                .memory_place = MemoryPlace::before_head,
                .output_rule = OutputRule::usual},
    KnownLayout{.about = "safe-control-gym",
                .head = "actor.pi_net.fcs.",
                .head_is_sequence = true,
                .must_have = {"actor.pi_net.fcs."},
                .marks = {"actor.logstd"},
                .is_list = true},
    KnownLayout{
        .about = "rsl_rl",
        .head = "actor.",
        .head_is_sequence = true,
        .must_have = {"actor.0."},
        .marks = {"std", "log_std", "actor_obs_normalizer.", "obs_norm_state_dict.", "memory_a."},
        .memory_place = MemoryPlace::first,
        .output_rule = OutputRule::usual},
    KnownLayout{.about = "skrl",
                .bodies = {"net_container."},
                .head = "policy_layer",
                .must_have = {"policy_layer."},
                .marks = {"log_std_parameter", "state_preprocessor.", "observation_preprocessor."},
                .output_rule = OutputRule::usual},
    KnownLayout{.about = "CleanRL's PPO",
                .head = "actor_mean.",
                .head_is_sequence = true,
                .must_have = {"actor_mean.0."},
                .marks = {"actor_logstd"},
                .output_rule = OutputRule::usual},
    KnownLayout{.about = "CleanRL's SAC",
                .bodies = {"fc"},
                .head = "fc_mean",
                .must_have = {"fc_mean."},
                .marks = {"fc_logstd.", "action_scale"},
                .action = ActionKind::squashed,
                .activation = Activation::relu,
                .output = Activation::tanh},
    KnownLayout{.about = "CleanRL's TD3 or DDPG",
                .bodies = {"fc"},
                .head = "fc_mu",
                .must_have = {"fc_mu."},
                .marks = {"action_scale"},
                .action = ActionKind::squashed,
                .activation = Activation::relu,
                .output = Activation::tanh},
};

}  // namespace eagerx::gen
