// Gradients of all parameters from a part of a minibatch.
#pragma once

#include <array>
#include <vector>

#include "targets/environments/train/model.hpp"

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

  /// All that are sums of float32.
  std::array<std::vector<float>*, 3> vectors() { return {&actor, &critic, &log_deviation}; }
  void clear();
  void add(Gradient& more);
};

}  // namespace eagerx::train
