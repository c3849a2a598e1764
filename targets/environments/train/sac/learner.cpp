#include "targets/environments/train/sac/learner.hpp"

#include <algorithm>
#include <eagerx/math.hpp>

#include "targets/environments/train/sac/squashed.hpp"

namespace eagerx::train::sac {

void Gradient::clear() {
  for (auto* values : {&actor, &critics[0], &critics[1]})
    std::fill(values->begin(), values->end(), 0.0F);
  log_probability = deviation = loss = 0.0;
}

void Gradient::add(const Kernels& kernels, const Gradient& more) {
  kernels.add(more.actor.data(), actor.data(), actor.size());
  for (std::size_t c = 0; c < critics.size(); ++c)
    kernels.add(more.critics[c].data(), critics[c].data(), critics[c].size());
  log_probability += more.log_probability;
  deviation += more.deviation;
  loss += more.loss;
}

Learner::Learner(const Model& model, std::size_t tiles)
    : gradient(model),
      tiles_(tiles),
      numbers_(model.actor.outputs() / 2),
      width_(model.critic.inputs() - numbers_),
      seen_by_actor_(model.actor.inputs()),
      actor_width_(model.actor.row()),
      critic_width_(model.critic.row()),
      observation_(width_),
      next_(width_),
      action_(numbers_),
      reward_(1),
      continues_(1),
      target_(1),
      sampled_(numbers_),
      noise_(numbers_),
      deviation_(numbers_),
      spread_(numbers_),
      rows_(kLanes * width_),
      actor_rows_(tiles * actor_width_),
      actor_deltas_(tiles * actor_width_),
      next_row_(actor_width_),
      scratch_(tiles * kLanes) {
  for (std::size_t c = 0; c < 2; ++c) {
    critic_rows_[c].resize(tiles * critic_width_);
    critic_deltas_[c].resize(tiles * critic_width_);
    row_[c].resize(critic_width_);
    deltas_[c].resize(critic_width_);
  }
}

void Learner::learn(const Frozen& frozen, Random random) {
  std::vector<std::size_t> places(tiles_ * kLanes);
  const auto size = static_cast<std::uint32_t>(frozen.model.memory.size());
  for (std::size_t& place : places) place = random.below(size);
  learn(frozen, places, random);
}

void Learner::learn(const Frozen& frozen, const std::vector<std::size_t>& places, Random random) {
  gradient.clear();
  for (std::size_t tile = 0; tile < tiles_; ++tile) {
    load(frozen, places, tile);
    estimate_target(frozen, random);
    evaluate(frozen, tile);
    improve(frozen, tile, random);
  }
  backward(frozen);
}

void Learner::load(const Frozen& frozen, const std::vector<std::size_t>& places, std::size_t tile) {
  const Memory& memory = frozen.model.memory;
  for (std::size_t l = 0; l < kLanes; ++l) {
    const Transition one = memory.at(places[tile * kLanes + l]);
    std::copy_n(one.observation, width_, &rows_[l * width_]);
    for (std::size_t j = 0; j < numbers_; ++j) action_[j].lane[l] = one.action[j];
    reward_[0].lane[l] = one.reward * frozen.reward_scale;
    continues_[0].lane[l] = one.continues;
  }
  frozen.normaliser.load(rows_.data(), observation_.data());
  for (std::size_t l = 0; l < kLanes; ++l) {
    std::copy_n(memory.at(places[tile * kLanes + l]).next, width_, &rows_[l * width_]);
  }
  frozen.normaliser.load(rows_.data(), next_.data());
}

/// Actions of the actor, whose answers are in `row`, with the logarithms of their probabilities.
void Learner::sample(const Frozen& frozen, const Simd* row, Random& random) {
  const Simd* means = row + frozen.model.actor.output();
  std::copy_n(means + numbers_, numbers_, spread_.data());
  frozen.kernels.tanh(spread_.data(), numbers_);
  log_probability_ = {};
  for (std::size_t j = 0; j < numbers_; ++j) {
    for (std::size_t l = 0; l < kLanes; ++l) {
      const float log_deviation = log_deviation_of(spread_[j].lane[l]);
      const float noise = random.normal(0.0F, 1.0F);
      const float deviation = exp(log_deviation);
      const float x = means[j].lane[l] + deviation * noise;
      noise_[j].lane[l] = noise;
      deviation_[j].lane[l] = deviation;
      sampled_[j].lane[l] = x;
      log_probability_.lane[l] += log_probability_of(noise, log_deviation, x);
    }
  }
  frozen.kernels.tanh(sampled_.data(), numbers_);
}

/// The target of the critics for the samples: the reward and what the actor gets from there on, as
/// the lower target has it.
void Learner::estimate_target(const Frozen& frozen, Random& random) {
  const Model& model = frozen.model;
  std::copy_n(next_.begin(), seen_by_actor_, next_row_.begin());
  model.actor.forward(frozen.kernels, model.actor_parameters.data(), next_row_.data());
  sample(frozen, next_row_.data(), random);
  for (std::size_t c = 0; c < 2; ++c) {
    std::copy_n(next_.begin(), width_, row_[c].begin());
    std::copy_n(sampled_.begin(), numbers_, row_[c].begin() + static_cast<std::ptrdiff_t>(width_));
    model.critic.forward(frozen.kernels, model.critics[c].target.data(), row_[c].data());
  }
  const std::size_t output = model.critic.output();
  for (std::size_t l = 0; l < kLanes; ++l) {
    const float least = min(row_[0][output].lane[l], row_[1][output].lane[l]);
    const float value = least - frozen.temperature * log_probability_.lane[l];
    target_[0].lane[l] = reward_[0].lane[l] + frozen.settings.gamma * continues_[0].lane[l] * value;
  }
}

/// The critics' derivatives of half their squared error.
void Learner::evaluate(const Frozen& frozen, std::size_t tile) {
  const Model& model = frozen.model;
  const std::size_t output = model.critic.output();
  for (std::size_t c = 0; c < 2; ++c) {
    Simd* row = critic_row(c, tile);
    std::copy_n(observation_.begin(), width_, row);
    std::copy_n(action_.begin(), numbers_, row + width_);
    model.critic.forward(frozen.kernels, model.critics[c].parameters.data(), row);
    Simd& delta = critic_deltas_[c][tile * critic_width_ + output];
    for (std::size_t l = 0; l < kLanes; ++l) {
      const float error = row[output].lane[l] - target_[0].lane[l];
      delta.lane[l] = error;
      gradient.loss += 0.5 * double{error} * error;
    }
  }
}

/// The actor's derivatives of temperature * log probability - what the lower critic says.
void Learner::improve(const Frozen& frozen, std::size_t tile, Random& random) {
  const Model& model = frozen.model;
  Simd* row = &actor_rows_[tile * actor_width_];
  std::copy_n(observation_.begin(), seen_by_actor_, row);
  model.actor.forward(frozen.kernels, model.actor_parameters.data(), row);
  sample(frozen, row, random);
  for (std::size_t c = 0; c < 2; ++c) {
    std::copy_n(observation_.begin(), width_, row_[c].begin());
    std::copy_n(sampled_.begin(), numbers_, row_[c].begin() + static_cast<std::ptrdiff_t>(width_));
    model.critic.forward(frozen.kernels, model.critics[c].parameters.data(), row_[c].data());
  }
  const std::size_t output = model.critic.output();
  for (std::size_t l = 0; l < kLanes; ++l) {
    const bool first = row_[0][output].lane[l] <= row_[1][output].lane[l];
    deltas_[0][output].lane[l] = first ? 1.0F : 0.0F;
    deltas_[1][output].lane[l] = first ? 0.0F : 1.0F;
    gradient.log_probability += log_probability_.lane[l];
  }
  for (std::size_t c = 0; c < 2; ++c) {
    model.critic.input_slopes(frozen.kernels, model.critics[c].parameters.data(), row_[c].data(),
                              deltas_[c].data());
  }
  slopes(frozen, &actor_deltas_[tile * actor_width_ + model.actor.output()]);
}

void Learner::slopes(const Frozen& frozen, Simd* actor_deltas) {
  for (std::size_t j = 0; j < numbers_; ++j) {
    for (std::size_t l = 0; l < kLanes; ++l) {
      const float action = sampled_[j].lane[l];
      const float value = deltas_[0][width_ + j].lane[l] + deltas_[1][width_ + j].lane[l];
      // By the number whose tanh the action is: -log(1 - tanh²) grows by 2 tanh.
      const float slope = frozen.temperature * 2.0F * action - value * (1.0F - action * action);
      const float deviation = deviation_[j].lane[l];
      const float by_log_deviation = slope * deviation * noise_[j].lane[l] - frozen.temperature;
      actor_deltas[j].lane[l] = slope;
      actor_deltas[numbers_ + j].lane[l] =
          by_log_deviation * log_deviation_slope(spread_[j].lane[l]);
      gradient.deviation += deviation / static_cast<float>(numbers_);
    }
  }
}

void Learner::backward(const Frozen& frozen) {
  const Model& model = frozen.model;
  model.actor.backward(frozen.kernels, model.actor_parameters.data(), actor_rows_.data(),
                       actor_deltas_.data(), tiles_, scratch_.data(), gradient.actor.data());
  for (std::size_t c = 0; c < 2; ++c) {
    model.critic.backward(frozen.kernels, model.critics[c].parameters.data(),
                          critic_rows_[c].data(), critic_deltas_[c].data(), tiles_, scratch_.data(),
                          gradient.critics[c].data());
  }
}

}  // namespace eagerx::train::sac
