// Gradients of one minibatch of proximal policy optimization.
#pragma once

#include <cstddef>
#include <vector>

#include "targets/environments/train/choice.hpp"
#include "targets/environments/train/gradient.hpp"
#include "targets/environments/train/rollout.hpp"

namespace eagerx::train {

/// The data common to all samples of an update.
struct PpoUpdate {
  const Settings& settings;
  const Head& head;
  const Model& model;
  const Kernels& kernels;
  const std::vector<float>& precision;  // [outputs] 1 / deviation of the actions
  float advantage_mean = 0.0F, advantage_scale = 1.0F;
  std::size_t minibatches = 1;  // of a rollout
};

/// The gradient of every Mth tile of one rollout; with a memory, of every Mth sequence of them.
class PpoLearner {
 public:
  PpoLearner(const Settings& settings, const Model& model);
  void learn(const PpoUpdate& update, const Rollout& rollout, std::size_t first);

  Gradient gradient;

 private:
  static constexpr std::size_t kBlock = 8;  // tiles whose rows fit into the cache

  /// The state before step `t` of sixteen sequences.
  void recall(const Model& model, const Rollout& rollout, std::size_t sequence, std::size_t t);
  void evaluate(const PpoUpdate& update, const Rollout& rollout, std::size_t tile,
                std::size_t place);
  /// Derivatives of the clipped loss of one sample by the means and the logarithms of the
  /// deviations.
  void actor_loss(const PpoUpdate& update, const Rollout& rollout, std::size_t tile, std::size_t l,
                  const Simd* means, Simd* deltas);
  /// The same for choices, by their scores. A choice that is nearly certain is not tried again: the
  /// entropy keeps it from becoming so too soon.
  void choice_loss(const PpoUpdate& update, const Rollout& rollout, std::size_t tile, std::size_t l,
                   const Simd* scores, Simd* deltas);
  /// The derivative of the clipped loss of one sample by the logarithm of its probability.
  float clipped_slope(const PpoUpdate& update, const Rollout& rollout, std::size_t tile,
                      std::size_t l, float log_p);
  void backward(const Kernels& kernels, const Model& model, std::size_t tiles);

  const std::size_t block_;                                        // tiles that are learnt at once
  Simds actor_rows_, actor_deltas_, critic_rows_, critic_deltas_;  // [block_][row]
  Simds scratch_;
  Simds continues_;              // [block_] of a sequence
  std::vector<Choice> choices_;  // of one sample
};

}  // namespace eagerx::train
