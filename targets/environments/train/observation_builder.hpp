// The rows that networks learn from: observations, then the inputs of the critic only.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "targets/environments/train/client.hpp"
#include "targets/environments/train/simd.hpp"

namespace eagerx::train {

/// Combines the results of the library in `rows`, which must outlive this. If the critic has only
/// observations, no other columns exist.
class ObservationBuilder {
 public:
  ObservationBuilder(const Description& description, Rows& rows)
      : observed_(description.observation_numbers()),
        seen_(description.critic_numbers()),
        rows_(rows),
        critic_(rows.reward.size() * seen_),
        own_(seen_ > 0 ? std::max(rows.reward.size(), kLanes) * width() : 0),
        own_final_(own_.size()) {}

  /// Numbers of a row; the actor sees the first actor_width() of them.
  std::size_t width() const { return observed_ + seen_; }
  std::size_t actor_width() const { return observed_; }

  /// [environments][width()] of the last step or reset, and where an episode ended its last row;
  /// at least kLanes rows, of which those beyond are 0.
  float* now() { return seen_ > 0 ? own_.data() : rows_.observation.data(); }
  float* at_end() { return seen_ > 0 ? own_final_.data() : rows_.final_observation.data(); }

  /// After each reset, and each step.
  void look(Environments& environments) {
    if (seen_ == 0) return;
    environments.critic(critic_.data(), nullptr);
    put_together(rows_.observation, own_);
  }
  void look_at_ends(Environments& environments) {
    if (seen_ == 0) return;
    environments.critic(nullptr, critic_.data());
    put_together(rows_.final_observation, own_final_);
  }
  /// Ends an episode with the current rows.
  void end(std::size_t environment) {
    const std::size_t first = environment * width();
    std::copy_n(now() + first, width(), at_end() + first);
  }

 private:
  void put_together(const std::vector<float>& observations, std::vector<float>& rows) const {
    for (std::size_t e = 0; e < rows_.reward.size(); ++e) {
      float* const row = std::copy_n(&observations[e * observed_], observed_, &rows[e * width()]);
      std::copy_n(&critic_[e * seen_], seen_, row);
    }
  }

  std::size_t observed_, seen_;
  Rows& rows_;
  std::vector<float> critic_;           // [environments][seen_]
  std::vector<float> own_, own_final_;  // [environments or more][width()]
};

}  // namespace eagerx::train
