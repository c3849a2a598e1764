// GymEngine's data of each object.
#pragma once

#include <cstdint>
#include <eagerx/math/vocabulary.hpp>
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
  CountOf<Real> terminated{};         // 1 if any step of this episode said so
  CountOf<Real> truncated{};

  /// State and attributes as the model has them, action zero, a new episode.
  void reset() {
    state = Model::initial_state();
    attributes = Model::default_attributes();
    next_action = {};
    begin_episode();
  }

  /// No step made yet. Every engine node that depends on it calls it at its reset.
  void begin_episode() {
    terminated = {};
    truncated = {};
    steps_ = {};
    unread_ = {};
    reward_ = {};
    sum_ = {};
  }

  /// One step of the environment with next_action.
  void step() {
    const GymOutcome<Real> outcome = Model::step(state, next_action, attributes);
    steps_ += one_if<Real>(steps_ != Count(std::numeric_limits<std::uint32_t>::max()));
    terminated = terminated | one_if<Real>(outcome.terminated);
    truncated = truncated | one_if<Real>(outcome.truncated);
    if constexpr (Model::kMaxSteps != 0)
      truncated = truncated | one_if<Real>(steps_ >= Count(Model::kMaxSteps));
    reward_ = outcome.reward;
    sum_ = select(unread_ != Count(0U), sum_ + reward_, reward_);
    unread_ = Count(1U);
  }

  /// The sum of the rewards since the last call; without a step in between, the last single reward,
  /// zero before the first step.
  Real take_reward() {
    const Real result = select(unread_ != Count(0U), sum_, reward_);
    unread_ = {};
    return result;
  }

 private:
  using Count = CountOf<Real>;

  Count steps_{};
  Count unread_{};  // 1 if sum_ holds rewards that were not taken
  Real reward_{};
  Real sum_{};
};

}  // namespace eagerx::models
