// What GymEngine keeps for each object.
#pragma once

#include <cstdint>
#include <limits>
#include <models/engines/gym_engine/gym_model.hpp>

namespace eagerx::models {

/// One environment. All bytes are zero until the first reset().
template <GymModel ModelType>
class GymSimulator {
 public:
  using Model = ModelType;
  using Real = typename Model::Real;

  GymStateVector<Model> state{};      // [kStates]
  GymAttributes<Model> attributes{};  // [kAttributes], in the order of kAttributeNames
  GymAction<Model> next_action{};     // [kActions], for the next step
  bool terminated = false;            // in any step of this episode
  bool truncated = false;

  /// State and attributes as the model has them, action zero, a new episode.
  void reset() {
    state = Model::initial_state();
    attributes = Model::default_attributes();
    next_action = {};
    begin_episode();
  }

  /// No step made yet. Every engine node that depends on it calls it at its reset.
  void begin_episode() {
    terminated = false;
    truncated = false;
    steps_ = 0;
    unread_ = false;
    reward_ = {};
    sum_ = {};
  }

  /// One step of the environment with next_action.
  void step() {
    const GymOutcome<Real> outcome = Model::step(state, next_action, attributes);
    if (steps_ != std::numeric_limits<std::uint32_t>::max()) ++steps_;
    const bool too_long = Model::kMaxSteps != 0 && steps_ >= Model::kMaxSteps;
    terminated = terminated || outcome.terminated;
    truncated = truncated || outcome.truncated || too_long;
    reward_ = outcome.reward;
    sum_ = unread_ ? sum_ + reward_ : reward_;
    unread_ = true;
  }

  /// The sum of the rewards since the last call; without a step in between, the last single reward,
  /// zero before the first step.
  Real take_reward() {
    const Real result = unread_ ? sum_ : reward_;
    unread_ = false;
    return result;
  }

 private:
  std::uint32_t steps_ = 0;
  bool unread_ = false;  // sum_ holds rewards that nobody took
  Real reward_{};
  Real sum_{};
};

}  // namespace eagerx::models
