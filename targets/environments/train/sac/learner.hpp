// The gradient of a part of a batch.
#pragma once

#include <array>
#include <vector>

#include "targets/environments/train/kernels.hpp"
#include "targets/environments/train/sac/model.hpp"

namespace eagerx::train::sac {

/// The constants of an update.
struct Frozen {
  const Kernels& kernels;
  const train::Settings& settings;
  const Model& model;
  const Normaliser& normaliser;
  float reward_scale;
  float temperature;
};

/// Sums over samples.
struct Gradient {
  explicit Gradient(const Model& model)
      : actor(model.actor.parameters()),
        critics{std::vector<float>(model.critic.parameters()),
                std::vector<float>(model.critic.parameters())} {}
  std::vector<float> actor;
  std::array<std::vector<float>, 2> critics;
  double log_probability = 0.0;  // of the sampled actions
  double deviation = 0.0;        // of the actions before tanh, mean over their numbers
  double loss = 0.0;             // half the squared errors of both critics

  void clear();
  void add(const Kernels& kernels, const Gradient& more);
};

class Learner {
 public:
  /// `tiles`: of a part, sixteen samples each.
  Learner(const Model& model, std::size_t tiles);

  Gradient gradient;

  /// Samples transitions from the memory with `random`, and sums up their gradients.
  void learn(const Frozen& frozen, Random random);
  /// The same for transitions at these places of the memory [tiles * kLanes].
  void learn(const Frozen& frozen, const std::vector<std::size_t>& places, Random random);

 private:
  void load(const Frozen& frozen, const std::vector<std::size_t>& places, std::size_t tile);
  void sample(const Frozen& frozen, const Simd* row, Random& random);
  void estimate_target(const Frozen& frozen, Random& random);
  void evaluate(const Frozen& frozen, std::size_t tile);
  void improve(const Frozen& frozen, std::size_t tile, Random& random);
  void slopes(const Frozen& frozen, Simd* actor_deltas);
  void backward(const Frozen& frozen);
  Simd* critic_row(std::size_t critic, std::size_t tile) {
    return &critic_rows_[critic][tile * critic_width_];
  }

  std::size_t tiles_, numbers_;
  std::size_t width_, seen_by_actor_;  // of what the critics see, and of that the first ones
  std::size_t actor_width_, critic_width_;
  // Of a tile: samples, and the actions that the actor samples.
  Simds observation_, next_;  // [width] normalised
  Simds action_;              // [numbers] of the memory
  Simds reward_, continues_, target_;
  Simds sampled_, noise_, deviation_, spread_;  // [numbers]; of each sampled action
  Simd log_probability_{};
  std::vector<float> rows_;                           // [kLanes][width] scratch
  Simds actor_rows_, actor_deltas_;                   // [tiles][actor row]
  std::array<Simds, 2> critic_rows_, critic_deltas_;  // [tiles][critic row]
  std::array<Simds, 2> row_, deltas_;                 // [critic row] scratch
  Simds next_row_;                                    // [actor row] scratch
  Simds scratch_;
};

}  // namespace eagerx::train::sac
