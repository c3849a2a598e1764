// The table of old and new names in files and on command lines. Errors suggest the new name,
// `eagerx-gen fix` writes it, and files that a program has written (checkpoints, records, tables)
// may contain either.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace eagerx::host {

/// The kind of thing that a name denotes. For a key of a file, the title of its mapping in
/// messages.
inline constexpr std::string_view kAnyMapping = "";  // that has the new name
inline constexpr std::string_view kTrainSettings = "settings of a training";
inline constexpr std::string_view kTrainOptions = "options of train";
inline constexpr std::string_view kCurveColumns = "columns of a learning curve";

struct Renamed {
  std::string_view where, old_name, new_name;
};

inline constexpr auto kRenamed = std::to_array<Renamed>({
    {"safety", "hang", "heartbeat_timeout"},
    {kAnyMapping, "packs", "vectorized"},
    {kAnyMapping, "pack_registers", "simd_registers"},
    {kTrainSettings, "layers", "net_arch"},
    {kTrainSettings, "activation", "activation_fn"},
    {kTrainSettings, "memory", "rnn"},
    {kTrainSettings, "memory_units", "rnn_hidden_size"},
    {kTrainSettings, "memory_steps", "bptt_steps"},
    {kTrainSettings, "discount", "gamma"},
    {kTrainSettings, "trace_decay", "gae_lambda"},
    {kTrainSettings, "environments", "n_envs"},
    {kTrainSettings, "horizon", "n_steps"},
    {kTrainSettings, "most_horizon", "max_n_steps"},
    {kTrainSettings, "minibatches", "n_minibatches"},
    {kTrainSettings, "epochs", "n_epochs"},
    {kTrainSettings, "clip", "clip_range"},
    {kTrainSettings, "entropy", "ent_coef"},
    {kTrainSettings, "gradient_norm", "max_grad_norm"},
    {kTrainSettings, "least_learning_rate", "min_learning_rate"},
    {kTrainSettings, "most_learning_rate", "max_learning_rate"},
    {kTrainSettings, "divergence", "target_kl"},
    {kTrainSettings, "stop_divergence", "kl_stop_factor"},
    {kTrainSettings, "first_deviation", "initial_std"},
    {kTrainSettings, "least_deviation", "min_std"},
    {kTrainSettings, "most_deviation", "max_std"},
    {kTrainSettings, "deviation_rate", "std_learning_rate_ratio"},
    {kTrainSettings, "sac_environments", "sac_n_envs"},
    {kTrainSettings, "sac_horizon", "train_freq"},
    {kTrainSettings, "sac_batch", "batch_size"},
    {kTrainSettings, "sac_updates", "utd_ratio"},
    {kTrainSettings, "sac_memory", "buffer_size"},
    {kTrainSettings, "sac_random_steps", "learning_starts"},
    {kTrainSettings, "sac_target_share", "tau"},
    {kTrainSettings, "sac_averaging", "sac_ema_rate"},
    {kTrainSettings, "sac_first_temperature", "initial_ent_coef"},
    {kTrainSettings, "sac_entropy", "target_entropy_per_action"},
    {kTrainSettings, "sac_reward_scale", "reward_scale"},
    {kTrainSettings, "sac_scale_steps", "norm_window_steps"},
    {kTrainSettings, "normalise", "norm_obs"},
    {kTrainSettings, "averaging", "ema_decay"},
    {kTrainSettings, "averaging_share", "ema_window_fraction"},
    {kTrainSettings, "hard_share", "failure_replay_fraction"},
    {kTrainSettings, "evaluation_every", "eval_interval"},
    {kTrainSettings, "evaluation_episodes", "n_eval_episodes"},
    {kTrainSettings, "success_share", "target_success_rate"},
    {kTrainSettings, "hard-starts", "failure-replay"},  // in checkpoints: the hash of the table
    {kCurveColumns, "success", "success_rate"},
    {kCurveColumns, "evaluation_return", "eval_return"},
    {kCurveColumns, "evaluation_success", "eval_success_rate"},
    {kCurveColumns, "deviation", "std"},
    {kCurveColumns, "step_size", "learning_rate"},
    {kCurveColumns, "divergence", "approx_kl"},
    {kCurveColumns, "stage_success", "stage_success_rate"},
    {kTrainOptions, "--discount", "--gamma"},
    {kTrainOptions, "--hard-starts", "--failure-replay"},
});

/// The present name of `name`; empty if it is not a former name there.
constexpr std::string_view new_name(std::string_view where, std::string_view name) {
  for (const Renamed& one : kRenamed) {
    if ((one.where == where || one.where == kAnyMapping) && one.old_name == name)
      return one.new_name;
  }
  return {};
}

/// The former name of `name`; empty if it was never renamed.
constexpr std::string_view former_name(std::string_view where, std::string_view name) {
  for (const Renamed& one : kRenamed) {
    if (one.where == where && one.new_name == name) return one.old_name;
  }
  return {};
}

/// "write `gae_lambda`, the new name of `trace_decay`"; empty if it is not a former name.
inline std::string help_for_renamed(std::string_view where, std::string_view name) {
  const std::string_view now = new_name(where, name);
  if (now.empty()) return {};
  return "write `" + std::string(now) + "`, the new name of `" + std::string(name) + "`";
}

}  // namespace eagerx::host
