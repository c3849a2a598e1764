// The parameters that SAC learns.
#pragma once

#include <array>
#include <eagerx/random.hpp>
#include <string>

#include "targets/environments/train/network.hpp"
#include "targets/environments/train/policy.hpp"
#include "targets/environments/train/sac/memory.hpp"
#include "targets/environments/train/settings.hpp"
#include "targets/environments/train/statistics.hpp"

namespace eagerx::train::sac {

/// A critic and the slow copy of it that others learn from.
struct Critic {
  Critic(const Network& network, Random random)
      : parameters(network.sampled(random, 1.0F)), target(parameters), adam(network.parameters()) {}
  std::vector<float> parameters, target;
  Adam adam;
};

inline constexpr std::uint64_t kMostReplayed = 1'000'000'000'000;

/// Actor, critics and memory, with all that the next update depends on.
struct Model {
  /// `inputs` of the actor; the critics have `more` after them.
  Model(const train::Settings& settings, std::size_t inputs, const Head& head, std::size_t more = 0)
      : actor(inputs, settings.net_arch, 2 * head.numbers, settings.activation_fn),
        critic(inputs + more + head.numbers, settings.net_arch, 1, settings.activation_fn),
        actor_parameters(actor.sampled(random(settings, "train/actor"), 0.01F)),
        averaged(actor_parameters),
        critics{Critic(critic, random(settings, "train/critic")),
                Critic(critic, random(settings, "train/second_critic"))},
        log_temperature(1, log(settings.sac.initial_ent_coef)),
        actor_adam(actor.parameters()),
        temperature_adam(1),
        observations(inputs + more),
        returns(1),
        rewards(2),
        memory(inputs + more, head.numbers, settings.sac.buffer_size),
        gamma_(settings.gamma),
        settings_(settings.sac) {}

  Network actor;   // means of the actions before tanh, then what becomes their deviations
  Network critic;  // of what it sees, then actions: the discounted return times reward_scale
  std::vector<float> actor_parameters;
  std::vector<float> averaged;  // running mean of actor_parameters: the policy
  std::array<Critic, 2> critics;
  std::vector<float> log_temperature;  // [1]
  Adam actor_adam, temperature_adam;
  Statistics observations;    // [of what the critics see], those of the actor first
  Statistics returns;         // [1] discounted, while they run
  Statistics rewards;         // [2] of a step: the reward, and 1 until the task is terminated
  double reward_scale = 0.0;  // of the rewards that the critics have learned; 0: of none yet
  Memory memory;
  bool was_taught = false;     // it began with what another training had learnt, or with logs
  std::uint64_t replayed = 0;  // transitions of logs

  /// The factor of the rewards that the critics are to learn, from what was seen so far.
  double estimated_scale() const;
  /// Updates that there should have been by now.
  std::uint64_t due() const {
    if (memory.added < settings_.learning_starts) return 0;
    return static_cast<std::uint64_t>(
        static_cast<double>(memory.added - settings_.learning_starts) *
        double{settings_.utd_ratio});
  }
  /// Whether it has as many transitions and updates as result from that number of iterations.
  bool is_due(std::uint32_t iterations) const {
    const std::uint64_t steps = settings_.n_envs * settings_.train_freq;
    return replayed <= kMostReplayed && memory.added == iterations * steps + replayed &&
           actor_adam.steps == due();
  }

 private:
  static Random random(const train::Settings& settings, const char* name) {
    return {{settings.seed, 0, 0}, entity_id(name)};
  }

  double gamma_;
  Settings settings_;
};

/// The network that is deployed: the actor without the deviations.
Network deployed(const train::Settings& settings, const Model& model);
/// Its parameters, with the normalisation inside of its first layer.
std::vector<float> deployed_parameters(const Network& network, const Model& model);

}  // namespace eagerx::train::sac
