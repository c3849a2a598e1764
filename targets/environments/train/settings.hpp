// Settings of a training: with one library, the same settings give the same bits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/policy/activation.hpp>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "targets/environments/train/sac/settings.hpp"

namespace eagerx::train {

class FailureReplay;

/// The runtime's; tanh and relu are trained.
using eagerx::Activation;
enum class Memory : std::uint8_t { none, gru, lstm };
enum class Schedule : std::uint8_t { adaptive, constant };

/// Of proximal policy optimisation (Schulman et al. 2017), unless SAC has its own. Names, ranges
/// and meanings are in options/train_settings.hpp; so are the values that a new one has.
struct Settings {
  Settings();

  std::string algorithm = "ppo";  // or "sac"
  sac::Settings sac;
  std::uint64_t seed = 1;
  /// The training does not end before the mean return of the evaluation reaches this, regardless of
  /// `success:`.
  double until_return = -std::numeric_limits<double>::infinity();

  std::vector<std::size_t> net_arch;  // widths, of actor and critic
  Activation activation_fn{};
  Memory rnn{};  // in front of the layers, of actor and critic each
  std::size_t rnn_hidden_size{};
  std::size_t bptt_steps{};  // that gradients go back; n_steps is a multiple
  float gamma{};             // γ
  float gae_lambda{};        // λ of generalised advantage estimation

  std::size_t n_envs{};  // a multiple of kParts * kLanes, or a part of that
  bool stagger{};
  std::size_t n_steps{};      // steps of each between two updates, at first
  std::size_t max_n_steps{};  // later
  std::size_t n_minibatches{};
  std::size_t n_epochs{};

  float clip_range{};     // of the ratio of probabilities
  float ent_coef{};       // weight of a choice's entropy; actions have a least deviation
  float max_grad_norm{};  // longest gradient

  float learning_rate{};  // of Adam; of the adaptive schedule the first
  Schedule schedule{};
  float min_learning_rate{}, max_learning_rate{};
  float target_kl{};       // Kullback-Leibler; the adaptive schedule keeps it
  float kl_stop_factor{};  // times `target_kl`: the iteration ends there; 0: never
  double decay_steps{};    // 0: none

  float initial_std{}, min_std{}, max_std{};  // of the actions, in -1…1
  float std_learning_rate_ratio{};            // over that of the networks

  bool norm_obs{};
  double freeze_after{};        // steps; 0: never
  float ema_decay{};            // weight of the past after an iteration
  float ema_window_fraction{};  // of all iterations, later; 0: none

  double failure_replay_fraction{};                     // of the environments
  std::shared_ptr<const FailureReplay> failure_replay;  // of `--failure-replay`; nullptr: none

  std::size_t eval_interval{};  // iterations
  std::size_t n_eval_episodes{};
  double target_success_rate{};  // of them, for the training to end

  /// The factor on learning rate and divergence after this number of steps.
  float decay(std::uint64_t steps) const {
    if (decay_steps <= 0.0) return 1.0F;
    return static_cast<float>(1.0 / (1.0 + static_cast<double>(steps) / decay_steps));
  }
};

/// Sets the one of this name by its text on a command line: "64,64". Throws Problem with kUsage.
void set(Settings& settings, std::string_view name, const std::string& text);

/// Throws Problem with kUsage for settings that do not go together.
void check(const Settings& settings);

/// Throws Problem with kUsage if the setting of this name is another algorithm's.
void check_algorithm(const Settings& settings, std::string_view name);

/// All of the table in words, such as "layers 64,64; activation tanh; …".
std::string text_of(const Settings& settings);

/// Such a text of an older version, with the names that settings have now.
std::string with_new_names(std::string_view text);

/// The difference of two such texts.
struct Difference {
  std::string name;
  std::string text;  // with both values: "layers 8 (here 64,64)"
};
std::vector<Difference> differences(std::string_view theirs, std::string_view ours);

/// The texts of all of them: "layers 8 (here 64,64), clip 0.1 (here 0.2)".
std::string difference(std::string_view theirs, std::string_view ours);
std::string text_of(const std::vector<Difference>& differences);

/// A training is cut into this number of parts, regardless of the number of threads: sums run
/// within parts, then over the parts in order.
inline constexpr std::size_t kParts = 8;

}  // namespace eagerx::train
