// Discrete choices by the outputs of a network.
#pragma once

#include <eagerx/math.hpp>
#include <vector>

#include "targets/environments/train/simd.hpp"

namespace eagerx::train {

/// The probabilities of scores: exp(score), divided by their sum.
class Choice {
 public:
  /// Of `scores` [count] of one sample.
  Choice(const Simd* scores, std::size_t count, std::size_t lane) : log_p_(count), p_(count) {
    float most = scores[0].lane[lane];
    for (std::size_t j = 1; j < count; ++j) most = max(most, scores[j].lane[lane]);
    float sum = 0.0F;
    for (std::size_t j = 0; j < count; ++j) sum += exp(scores[j].lane[lane] - most);
    const float log_sum = most + log(sum);
    for (std::size_t j = 0; j < count; ++j) {
      log_p_[j] = scores[j].lane[lane] - log_sum;
      p_[j] = exp(log_p_[j]);
      entropy_ -= p_[j] * log_p_[j];
    }
  }

  float probability(std::size_t j) const { return p_[j]; }
  float log_probability(std::size_t j) const { return log_p_[j]; }
  float entropy() const { return entropy_; }

  /// The choice at `place`, 0 to 1, in the cumulative distribution.
  std::size_t at(float place) const {
    std::size_t j = 0;
    for (; j + 1 < p_.size() && place >= p_[j]; ++j) place -= p_[j];
    return j;
  }

 private:
  std::vector<float> log_p_, p_;
  float entropy_ = 0.0F;
};

}  // namespace eagerx::train
