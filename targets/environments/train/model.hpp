// The learned parameters.
#pragma once

#include <algorithm>
#include <eagerx/math.hpp>
#include <eagerx/random.hpp>

#include "targets/environments/train/network.hpp"
#include "targets/environments/train/policy.hpp"
#include "targets/environments/train/settings.hpp"
#include "targets/environments/train/statistics.hpp"

namespace eagerx::train {

/// ln(2 pi) / 2, of the logarithm of a normal density.
inline constexpr float kHalfLogTwoPi = 0.9189385F;

/// Actor and critic with all that the next update depends on.
struct Model {
  /// `inputs` of the actor; the critic has `more` after them.
  Model(const Settings& settings, std::size_t inputs, const Head& head, std::size_t more = 0)
      : actor(inputs, settings.net_arch, head.outputs, settings.activation_fn,
              {settings.rnn, settings.rnn_hidden_size}),
        critic(inputs + more, settings.net_arch, 1, settings.activation_fn,
               {settings.rnn, settings.rnn_hidden_size}),
        actor_parameters(actor.sampled(random(settings, "train/actor"), 0.01F)),
        critic_parameters(critic.sampled(random(settings, "train/critic"), 1.0F)),
        log_deviation(head.chooses ? 0 : head.outputs, log(settings.initial_std)),
        averaged(actor_parameters),
        actor_adam(actor.parameters()),
        critic_adam(critic.parameters()),
        deviation_adam(log_deviation.size()),
        observations(inputs + more),
        returns(1),
        step_size(settings.learning_rate),
        remembered(std::max(settings.n_envs, kParts * kLanes) * 2 *
                   CellShape{settings.rnn, settings.rnn_hidden_size}.state()) {}

  Network actor;   // tanh of its outputs is the mean of the actions, or they are scores of choices
  Network critic;  // the discounted return, divided by the deviation of returns
  std::vector<float> actor_parameters, critic_parameters;
  std::vector<float> log_deviation;  // [outputs] of the actions; [0] of a choice
  std::vector<float> averaged;       // running mean of actor_parameters: the policy
  Adam actor_adam, critic_adam, deviation_adam;
  Statistics observations;  // [inputs of the critic], those of the actor first
  Statistics returns;       // [1] discounted, while they run
  float step_size;
  /// [environments, or a tile of each part][states of actor and critic] after the last iteration.
  std::vector<float> remembered;

 private:
  static Random random(const Settings& settings, const char* name) {
    return {{settings.seed, 0, 0}, entity_id(name)};
  }
};

}  // namespace eagerx::train
