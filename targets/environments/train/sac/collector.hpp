// The environments that SAC learns from, and their episodes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "targets/environments/train/algorithm.hpp"
#include "targets/environments/train/client.hpp"
#include "targets/environments/train/failure_replay.hpp"
#include "targets/environments/train/observation_builder.hpp"
#include "targets/environments/train/sac/model.hpp"
#include "targets/environments/train/spent.hpp"

namespace eagerx::train::sac {

class Collector {
 public:
  Collector(const train::Settings& settings, const Library& library, std::uint32_t longest);

  std::string stepping() const { return environments_.stepping(); }
  /// All environments begin the first episode of `seed`.
  void reset(std::uint64_t seed);
  /// From the next reset() on.
  void set_stage(const std::string& name) { environments_.set_stage(name); }
  /// A step of all with actions of the actor, or sampled evenly while it has learnt nothing yet.
  /// `time`: steps since the training began. The transitions go into the memory.
  void step(Model& model, const Normaliser& normaliser, const Kernels& kernels, bool is_random,
            std::uint32_t time);
  /// A step with the actions of transitions that the memory has; `back`: of the first environment,
  /// from its last transition.
  void step_again(const Memory& memory, std::size_t back);

  Sums observation_sums, return_sums;
  Sums reward_sums;               // of a step: the reward, and 1 until the task is terminated
  std::vector<Episode> episodes;  // that ended, in order of time
  Spent spent;                    // by all steps

 private:
  void act(const Model& model, const Normaliser& normaliser, const Kernels& kernels,
           std::uint32_t time);
  void step_environments();
  void record_step(Model& model, std::size_t environment, std::uint32_t time);
  bool count_reward(std::size_t environment);
  void sum_observations();
  Random noise(std::uint32_t time, std::size_t environment) const;

  const train::Settings& settings_;
  const Head head_;
  Environments environments_;
  std::size_t count_, numbers_;
  ReplayedEnvironments replayed_;
  Rows rows_;                             // [count] of the last step; [kLanes] of observations
  ObservationBuilder observer_;           // with what only the critics see
  std::size_t width_;                     // of that
  std::vector<float> before_;             // [count][width]
  std::vector<float> squashed_, action_;  // [count][numbers] in -1…1; in their bounds
  std::vector<double> return_;            // [count] of the episode so far
  std::vector<float> discounted_;         // [count] of the episode so far
  Simds row_, seen_;                      // scratch
};

}  // namespace eagerx::train::sac
