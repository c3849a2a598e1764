// Requirements of GymEngine on a model of a step-by-step environment.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <eagerx/math/vocabulary.hpp>
#include <eagerx/message.hpp>

namespace eagerx::models {

/// The results of a step, except the observation.
template <class Real>
struct GymOutcome {
  Real reward{};
  TruthOf<Real> terminated = false;  // the task is over, by success or failure
  TruthOf<Real> truncated = false;   // the episode is over for another reason
};

/// A model of an environment with step(action). It has
///   using Real = …;                                    // float, double, or a SIMD vector of them
///   static constexpr std::size_t kStates, kActions, kObservations, kAttributes;  // at least 1
///   static constexpr std::uint32_t kMaxSteps;          // truncated from this step on; 0: never
///   static constexpr std::array<const char*, kAttributes> kAttributeNames;  // as Gym calls them
///   static Array<Real, kStates> initial_state();       // until a reset sets it
///   static Array<Real, kAttributes> default_attributes();
///   static GymOutcome<Real> step(Array<Real, kStates>& state, const Array<Real, kActions>& action,
///                                const Array<Real, kAttributes>& attributes);
///   static Array<Real, kObservations> observe(const Array<Real, kStates>& state);
/// A Discrete action of Gym is one number, 0, 1, …
template <class Model>
concept GymModel = (Model::kStates > 0) && (Model::kActions > 0) && (Model::kObservations > 0) &&
                   (Model::kAttributes > 0) &&
                   (Model::kAttributeNames.size() == Model::kAttributes) &&
                   std::same_as<decltype(Model::initial_state()),
                                Array<typename Model::Real, Model::kStates>>&& std::
                       same_as<decltype(Model::observe(Model::initial_state())),
                               Array<typename Model::Real, Model::kObservations>>;

template <class Model>
using GymStateVector = Array<typename Model::Real, Model::kStates>;
template <class Model>
using GymAction = Array<typename Model::Real, Model::kActions>;
template <class Model>
using GymAttributes = Array<typename Model::Real, Model::kAttributes>;

}  // namespace eagerx::models
