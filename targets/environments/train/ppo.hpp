// Proximal policy optimization on many environments.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "targets/environments/train/algorithm.hpp"
#include "targets/environments/train/client.hpp"
#include "targets/environments/train/ppo_learner.hpp"
#include "targets/environments/train/ranks/gradient_sum.hpp"
#include "targets/environments/train/rollout.hpp"

namespace eagerx::train {

/// The share of the actor in the policy, its running mean, after this iteration, counted from 0: at
/// first a mean of all iterations, then of the last ones, and later of a growing tail, like
/// Polyak's. The longer a training runs, the smaller its improvements.
float share_of_actor(const Settings& settings, std::uint32_t iteration);

class Ppo : public Algorithm {
 public:
  Ppo(const Settings& settings, const Library& library, const Kernels& kernels, ThreadPool& pool,
      std::uint32_t longest, Ranks& ranks = environments::alone());

  const Model& model() const { return model_; }

  std::size_t environments() const override { return settings_.n_envs; }
  std::size_t parts() const override { return kParts; }
  std::string stepping() const override { return rollout(own_.first).stepping(); }
  void set_stage(const std::string& name) override;
  void begin_era() override;
  void remember_actions() override;
  void go_on() override;
  Result iterate() override;
  Network deployed() const override { return model_.actor; }
  std::vector<float> deployed_parameters() const override;
  const Statistics& observations() const override { return model_.observations; }
  double deviation() const override;
  double step_size() const override { return model_.step_size; }
  Spent spent() const override;
  Done done() const override { return done_; }
  std::string checkpoint(const std::string& conditions, const std::string& interface,
                         Progressed& progressed) const override;
  void restore(const std::string& bytes, const std::string& name, const std::string& conditions,
               Progressed& progressed) override;
  void begin_from(const std::string& bytes, const std::string& name,
                  const std::string& interface) override;
  std::string replay(const std::string& text, const std::string& name) override;

 private:
  /// Of this rank.
  Rollout& rollout(std::size_t part) const { return static_cast<Rollout&>(*parts_[part]); }
  /// Calls work(part) for each part of this rank, in parallel if the library supports it.
  /// Afterwards every rank has the statistics of all.
  void in_parts(const std::function<void(std::size_t part)>& work);
  std::vector<Episode> collect();
  std::size_t minibatches() const;
  /// Returns how often it has learnt from the rollouts.
  std::size_t learn();
  /// False if the policy has moved far enough.
  bool update(std::size_t minibatch);
  bool move();
  /// Parts of this rank.
  std::size_t own() const { return own_.end - own_.first; }
  void adapt_step_size();
  void average();
  void see();
  bool is_frozen() const;
  /// Factor from 1 down, for the learning rate and its target.
  float decay() const;
  /// Number of actions of a part in this era, after its last iteration.
  std::size_t actions_of_part() const;
  /// All of them, or fewer if they are not remembered.
  std::vector<float> actions() const;
  /// Makes actions() return these from now on, if their number is right.
  void take_up(const std::vector<float>& actions);

  const Settings settings_;
  const Head head_;
  Model model_;
  const std::string critic_;  // what only the critic sees, in words, for checkpoints
  const Kernels& kernels_;
  ThreadPool& pool_;
  Ranks& ranks_;
  const environments::Share own_;  // parts of this rank
  const bool has_threads_;
  bool remembers_ = false;
  std::vector<std::unique_ptr<RolloutStatistics>>
      parts_;  // [kParts] rollouts, where they are of this rank
  std::vector<std::unique_ptr<PpoLearner>> learners_;  // [own_] a part of a minibatch each
  GradientSum gradient_sum_;
  std::vector<float> precision_;  // [outputs] 1 / deviation of the actions
  double divergence_ = 0.0;
  std::vector<double> learning_s_;  // [own_] of processor time
  double updating_s_ = 0.0;         // the same, by the caller alone
  Done done_;
  float advantage_mean_ = 0.0F, advantage_scale_ = 1.0F;
};

}  // namespace eagerx::train
