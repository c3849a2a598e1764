// Proximal policy optimisation on many environments.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "targets/environments/train/client.hpp"
#include "targets/environments/train/rollout.hpp"

namespace eagerx::train {

/// Gradients of one part of a minibatch.
struct Gradient {
  explicit Gradient(const Model& model)
      : actor(model.actor.parameters()),
        critic(model.critic.parameters()),
        log_deviation(model.log_deviation.size()) {}
  std::vector<float> actor, critic, log_deviation;
  double divergence = 0.0;  // sum over the samples
  double count = 0.0;       // samples

  void clear();
  void add(const Gradient& more);
};

class Ppo {
 public:
  /// What an iteration learnt from.
  struct Result {
    std::vector<Episode> episodes;  // that ended, in order of time
    double divergence = 0.0;        // of the last minibatch
    std::size_t updates = 0;        // that were made
  };

  Ppo(const Settings& settings, const Library& library, const Kernels& kernels, Team& team,
      std::uint32_t longest);
  ~Ppo();

  Model& model() { return model_; }
  const Model& model() const { return model_; }
  std::uint32_t iteration = 0;

  /// All environments begin anew, with episodes that nothing but `era` and the seed decides. A
  /// training that goes on from here needs the model and the iteration only.
  void begin_era(std::uint32_t era);
  /// From now on actions are remembered, which go_on() needs in the middle of an era.
  void remember_actions();
  /// All that were taken in the first `iterations` of this era, or fewer if they are not
  /// remembered.
  std::vector<float> actions(std::uint32_t iterations) const;
  /// actions() gives these from now on, if they are those of so many iterations.
  void take_up(const std::vector<float>& actions, std::uint32_t iterations);
  /// All environments are brought to where they were after the actions that take_up() got.
  void go_on(std::uint32_t era);
  /// A rollout and the updates from it.
  Result iterate();
  /// How environments are stepped, and what made that slower.
  std::string stepping() const { return rollouts_.front()->stepping(); }
  /// Steps of all environments in one iteration.
  std::size_t steps() const { return settings_.environments * settings_.horizon; }

 private:
  class Learner;  // a part of a minibatch

  /// work(part) for each of the rollouts, at once if the library can.
  void in_parts(const std::function<void(std::size_t part)>& work);
  std::vector<Episode> collect();
  /// False if the policy has moved far enough.
  bool update(std::size_t minibatch);
  void adapt_step_size();
  void average();
  void see();
  bool is_frozen() const;
  /// From 1 down, of the learning rate and of what keeps it.
  float decay() const;

  const Settings settings_;
  const Head head_;
  Model model_;
  const Kernels& kernels_;
  Team& team_;
  const bool has_threads_;
  bool remembers_ = false;
  std::vector<std::unique_ptr<Rollout>> rollouts_;
  std::vector<std::unique_ptr<Learner>> learners_;
  std::vector<float> precision_;  // [outputs] 1 / deviation of the actions
  double divergence_ = 0.0;
  float advantage_mean_ = 0.0F, advantage_scale_ = 1.0F;
};

}  // namespace eagerx::train
