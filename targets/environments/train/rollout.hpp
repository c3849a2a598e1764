// Steps of some environments under the current policy, and the samples to learn from.
#pragma once

#include <algorithm>
#include <cstdint>
#include <eagerx/random.hpp>
#include <string>
#include <vector>

#include "targets/environments/train/algorithm.hpp"
#include "targets/environments/train/client.hpp"
#include "targets/environments/train/failure_replay.hpp"
#include "targets/environments/train/model.hpp"
#include "targets/environments/train/observation_builder.hpp"
#include "targets/environments/train/pace.hpp"
#include "targets/environments/train/policy.hpp"
#include "targets/environments/train/recurrent/states.hpp"
#include "targets/environments/train/rollout_statistics.hpp"
#include "targets/environments/train/spent.hpp"

namespace eagerx::train {

/// The constants of a rollout.
struct Frozen {
  const Kernels& kernels;
  const Settings& settings;
  const Model& model;
  Normaliser normaliser;
  std::vector<float> deviation;  // [outputs]
  float reward_scale;
  Pace pace;
};

/// One of kParts parts of the environments: some tiles of sixteen, or one of fewer. Samples are in
/// sequences, of bptt_steps or, without memory, of one step, sixteen side by side, in order of
/// time: those of a tile, or of a smaller one several consecutive ones. So [simds] is [sequences /
/// 16][steps of a sequence].
class Rollout final : public RolloutStatistics {
 public:
  Rollout(const Settings& settings, const Library& library, const Head& head, std::uint32_t longest,
          std::size_t part);

  /// From the next reset() on.
  void set_stage(const std::string& name) { environments_.set_stage(name); }
  /// All environments begin the first episode of `seed`.
  void reset(std::uint64_t seed);
  /// Steps all environments `horizon` times and estimates advantages.
  void collect(const Frozen& frozen);
  /// Steps all environments, which have just been reset, with `again` [steps][count][numbers] once
  /// more. They are then where they were when the last of these had been taken.
  void replay(const std::vector<float>& again, float discount);
  /// Restores the states of the networks for all environments from an earlier `remembered`.
  void recall(const float* states);

  /// How environments are stepped, and the reason if that is slow.
  std::string stepping() const { return environments_.stepping(); }
  std::size_t tiles() const { return (count_ + kLanes - 1) / kLanes; }
  /// The training data, after collect().
  std::size_t simds() const { return horizon_ * count_ / kLanes; }

  Simds inputs;             // [simds][inputs of the critic] normalised observations
  Simds actions;            // [simds][numbers] as sampled, in -1…1 or beyond; or the choice
  Simds log_probability;    // [simds] of the actions
  Simds advantage, target;  // [simds] target of the critic
  Simds continues;          // [simds] 1 where the episode went on behind the step, 0 where it ended
  /// [sequences / 16][state] the state at the beginning of each sequence.
  Simds actor_starts, critic_starts;
  bool remembers = false;  // in `taken`
  Spent spent;             // by all that this part has done

 private:
  struct Place {
    std::size_t simd, lane;
  };
  Place place(std::size_t step, std::size_t environment) const;
  void act(const Frozen& frozen, std::size_t step);
  void note_inputs(std::size_t step, std::size_t tile);
  void note_values(std::size_t step, std::size_t tile, const Simd& value);
  void note_states(std::size_t step);
  void forget();
  void sample_actions(const Frozen& frozen, std::size_t step, std::size_t tile, const Simd* means);
  void sample_choices(const Frozen& frozen, std::size_t step, std::size_t tile, const Simd* scores);
  Random noise(const Frozen& frozen, std::size_t step, std::size_t environment) const;
  void note_step(const Frozen& frozen, std::size_t step);
  void step_environments();
  void sample_cuts(std::uint64_t seed);
  void cut_first_episodes();
  void record_step(const Frozen& frozen, std::size_t step, std::size_t environment);
  bool count_reward(float discount, std::size_t environment);
  void begin_episode(std::size_t environment);
  void bootstrap(const Frozen& frozen, std::size_t step);
  void sum_observations();
  void estimate_advantages(const Settings& settings);
  /// Environments of a tile.
  std::size_t lanes() const { return std::min(count_, kLanes); }

  const Head& head_;
  Environments environments_;
  std::size_t count_, first_;
  std::size_t horizon_;  // of the last collect()
  std::size_t width_, numbers_;
  std::size_t sequence_;               // steps
  std::uint32_t longest_;              // steps of an episode; 0: first ones are not cut
  std::uint32_t time_ = 0;             // steps since reset()
  std::vector<std::uint32_t> cut_at_;  // [count] where the first episode of each ends
  std::vector<std::uint8_t> is_cut_;   // [count] in this step
  ReplayedEnvironments replayed_;
  Rows rows_;                      // [count] of the last step
  ObservationBuilder observer_;    // with what only the critic sees, [count][width]
  std::vector<float> action_;      // [count][numbers]
  std::vector<double> return_;     // [count] of the episode so far
  std::vector<float> discounted_;  // [count] of the episode so far
  std::vector<float> value_;       // [horizon + 1][count]
  std::vector<float> rewards_;     // [horizon][count] scaled
  Simds actor_row_, critic_row_;   // scratch
  States actor_states_, critic_states_;
};

}  // namespace eagerx::train
