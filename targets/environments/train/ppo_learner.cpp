#include "targets/environments/train/ppo_learner.hpp"

#include <algorithm>
#include <eagerx/math.hpp>
#include <utility>

namespace eagerx::train {

PpoLearner::PpoLearner(const Settings& settings, const Model& model)
    : gradient(model),
      block_(model.actor.memory() == nullptr ? kBlock : settings.bptt_steps),
      actor_rows_(block_ * model.actor.row()),
      actor_deltas_(block_ * model.actor.row()),
      critic_rows_(block_ * model.critic.row()),
      critic_deltas_(block_ * model.critic.row()),
      scratch_(block_ * kLanes),
      continues_(block_) {}

void PpoLearner::learn(const PpoUpdate& update, const Rollout& rollout, std::size_t first) {
  gradient.clear();
  const Model& model = update.model;
  const std::size_t steps = model.actor.memory() == nullptr ? 1 : block_;
  const std::size_t sequences = rollout.simds() / steps;
  std::size_t tiles = 0;
  for (std::size_t s = first; s < sequences; s += update.minibatches) {
    for (std::size_t t = 0; t < steps; ++t) {
      if (model.actor.memory() != nullptr) recall(model, rollout, s, t);
      evaluate(update, rollout, s * steps + t, tiles);
      if (++tiles == block_) backward(update.kernels, model, std::exchange(tiles, 0));
    }
  }
  backward(update.kernels, model, tiles);
}

void PpoLearner::recall(const Model& model, const Rollout& rollout, std::size_t sequence,
                        std::size_t t) {
  std::fill_n(continues_[t].lane, kLanes, 1.0F);
  if (t > 0) continues_[t] = rollout.continues[sequence * block_ + t - 1];
  const auto from = [&](const Network& network, const Simds& starts, Simds& rows) {
    Simd* row = &rows[t * network.row()];
    const Simd* state = t > 0 ? row - network.row() + network.memory()->after()
                              : &starts[sequence * network.memory()->shape().state()];
    train::recall(network, continues_[t], state, row);
  };
  from(model.actor, rollout.actor_starts, actor_rows_);
  from(model.critic, rollout.critic_starts, critic_rows_);
}

void PpoLearner::evaluate(const PpoUpdate& update, const Rollout& rollout, std::size_t tile,
                          std::size_t place) {
  const Model& model = update.model;
  const std::size_t width = model.critic.inputs();
  Simd* actor = &actor_rows_[place * model.actor.row()];
  Simd* critic = &critic_rows_[place * model.critic.row()];
  std::copy_n(&rollout.inputs[tile * width], model.actor.inputs(), actor);
  std::copy_n(&rollout.inputs[tile * width], width, critic);
  model.actor.forward(update.kernels, model.actor_parameters.data(), actor);
  model.critic.forward(update.kernels, model.critic_parameters.data(), critic);
  Simd* answers = actor + model.actor.output();
  Simd* deltas = &actor_deltas_[place * model.actor.row() + model.actor.output()];
  if (update.head.chooses) {
    for (std::size_t l = 0; l < kLanes; ++l) choice_loss(update, rollout, tile, l, answers, deltas);
  } else {
    update.kernels.tanh(answers, model.actor.outputs());
    for (std::size_t l = 0; l < kLanes; ++l) actor_loss(update, rollout, tile, l, answers, deltas);
    update.kernels.tanh_slope(answers, deltas, model.actor.outputs());
  }
  const Simd& value = critic[model.critic.output()];
  Simd& delta = critic_deltas_[place * model.critic.row() + model.critic.output()];
  for (std::size_t l = 0; l < kLanes; ++l) {
    delta.lane[l] = value.lane[l] - rollout.target[tile].lane[l];
  }
}

void PpoLearner::actor_loss(const PpoUpdate& update, const Rollout& rollout, std::size_t tile,
                            std::size_t l, const Simd* means, Simd* deltas) {
  const Model& model = update.model;
  const std::size_t outputs = model.log_deviation.size();
  const Simd* actions = &rollout.actions[tile * outputs];
  const auto distance = [&](std::size_t j) {  // from the mean, in deviations
    return (actions[j].lane[l] - means[j].lane[l]) * update.precision[j];
  };
  float log_p = 0.0F;
  for (std::size_t j = 0; j < outputs; ++j) {
    const float z = distance(j);
    log_p += -0.5F * z * z - model.log_deviation[j] - kHalfLogTwoPi;
  }
  const float slope = clipped_slope(update, rollout, tile, l, log_p);
  for (std::size_t j = 0; j < outputs; ++j) {
    const float z = distance(j);
    deltas[j].lane[l] = slope * z * update.precision[j];
    gradient.log_deviation[j] += slope * (z * z - 1.0F);
  }
}

void PpoLearner::choice_loss(const PpoUpdate& update, const Rollout& rollout, std::size_t tile,
                             std::size_t l, const Simd* scores, Simd* deltas) {
  const Head& head = update.head;
  const Simd* actions = &rollout.actions[tile * head.numbers];
  const auto chosen = [&](std::size_t j) { return static_cast<std::size_t>(actions[j].lane[l]); };
  choices_.clear();
  float log_p = 0.0F;
  for (std::size_t j = 0; j < head.numbers; scores += head.counts[j++]) {
    choices_.emplace_back(scores, head.counts[j], l);
    log_p += choices_.back().log_probability(chosen(j));
  }
  const float slope = clipped_slope(update, rollout, tile, l, log_p);
  for (std::size_t j = 0; j < head.numbers; deltas += head.counts[j++]) {
    const Choice& choice = choices_[j];
    for (std::size_t i = 0; i < head.counts[j]; ++i) {
      const float p = choice.probability(i);
      const float surprise = choice.log_probability(i) + choice.entropy();
      deltas[i].lane[l] =
          slope * ((i == chosen(j) ? 1.0F : 0.0F) - p) + update.settings.ent_coef * p * surprise;
    }
  }
}

float PpoLearner::clipped_slope(const PpoUpdate& update, const Rollout& rollout, std::size_t tile,
                                std::size_t l, float log_p) {
  const float log_ratio = clamp(log_p - rollout.log_probability[tile].lane[l], -10.0F, 10.0F);
  const float ratio = exp(log_ratio);
  const float advantage =
      (rollout.advantage[tile].lane[l] - update.advantage_mean) * update.advantage_scale;
  const float clip = update.settings.clip_range;
  const bool counts = advantage > 0.0F ? ratio < 1.0F + clip : ratio > 1.0F - clip;
  gradient.divergence += double{ratio} - 1.0 - log_ratio;  // Schulman 2020, never negative
  gradient.count += 1.0;
  return counts ? -advantage * ratio : 0.0F;
}

void PpoLearner::backward(const Kernels& kernels, const Model& model, std::size_t tiles) {
  if (tiles == 0) return;
  model.actor.backward(kernels, model.actor_parameters.data(), actor_rows_.data(),
                       actor_deltas_.data(), tiles, scratch_.data(), gradient.actor.data(),
                       continues_.data());
  model.critic.backward(kernels, model.critic_parameters.data(), critic_rows_.data(),
                        critic_deltas_.data(), tiles, scratch_.data(), gradient.critic.data(),
                        continues_.data());
}

}  // namespace eagerx::train
