#include "targets/environments/train/rollout.hpp"

#include <algorithm>
#include <cmath>
#include <eagerx/math.hpp>

#include "targets/environments/train/choice.hpp"
#include "targets/environments/train/client.hpp"

namespace eagerx::train {
Rollout::Rollout(const Settings& settings, const Library& library, const Head& head,
                 std::uint32_t longest, std::size_t part)
    : RolloutStatistics(library.description().observation_numbers() +
                        library.description().critic_numbers()),
      head_(head),
      environments_(library.functions(), static_cast<std::uint32_t>(settings.n_envs / kParts),
                    static_cast<std::uint32_t>(settings.n_envs / kParts * part), settings.seed,
                    longest, EAGERX_SAME_STEP),
      count_(settings.n_envs / kParts),
      first_(count_ * part),
      horizon_(pace_of(settings, library.description()).most),
      width_(observation_sums.sum.size()),
      numbers_(head.numbers),
      sequence_(settings.rnn == Memory::none ? 1 : settings.bptt_steps),
      longest_(!settings.stagger ? 0
               : longest > 0     ? longest
                                 : library.description().episode_steps),
      cut_at_(count_),
      is_cut_(count_),
      replayed_(settings, library, static_cast<std::uint32_t>(first_),
                static_cast<std::uint32_t>(count_)),
      rows_(library.description(), count_),
      observer_(library.description(), rows_),
      action_(count_ * numbers_),
      return_(count_),
      discounted_(count_),
      actor_states_(tiles(), {settings.rnn, settings.rnn_hidden_size}),
      critic_states_(actor_states_) {
  rows_.observation.resize(tiles() * kLanes * observer_.actor_width());
  rows_.final_observation = rows_.observation;
  rewards_.resize(horizon_ * count_);
  value_.resize(rewards_.size() + count_);
  const std::size_t simds = rewards_.size() / kLanes;
  inputs.resize(simds * width_);
  actions.resize(simds * numbers_);
  for (Simds* each : {&log_probability, &advantage, &target, &continues}) each->resize(simds);
  const std::size_t states = simds / sequence_ * actor_states_.width();
  for (Simds* each : {&actor_starts, &critic_starts}) each->resize(states);
}

void Rollout::reset(std::uint64_t seed) {
  replayed_.reset(environments_, seed, rows_.observation.data());
  observer_.look(environments_);
  return_.assign(count_, 0.0);
  discounted_.assign(count_, 0.0F);
  taken.clear();
  actor_states_.clear();
  critic_states_.clear();
  sample_cuts(seed);
  observation_sums.clear();
  sum_observations();
}

/// Episodes of one length would all be at the same place of it in every iteration, and what is
/// learnt at their ends would be forgotten at their beginnings. So the first ones are cut, each
/// elsewhere (as rsl_rl and others do, `init_at_random_ep_len`).
void Rollout::sample_cuts(std::uint64_t seed) {
  time_ = 0;
  for (std::size_t e = 0; e < count_; ++e) {
    Random random({seed, static_cast<std::uint32_t>(first_ + e), 0}, entity_id("train/cut"));
    cut_at_[e] = longest_ == 0 ? 0
                               : 1 + static_cast<std::uint32_t>(random.uniform(0.0F, 1.0F) *
                                                                static_cast<float>(longest_));
  }
}

/// As if they had run out of time.
void Rollout::cut_first_episodes() {
  ++time_;
  bool any = false;
  for (std::size_t e = 0; e < count_; ++e) {
    const bool cuts = cut_at_[e] == time_ && !rows_.ended(e);
    is_cut_[e] = cuts ? 1 : 0;
    any = any || cuts;
    if (!cuts) continue;
    rows_.truncated[e] = 1;
    observer_.end(e);
  }
  if (!any) return;
  environments_.reset_some(is_cut_.data(), rows_.observation.data());
  observer_.look(environments_);
}

void Rollout::replay(const std::vector<float>& again, float discount) {
  for (auto row = again.begin(); row != again.end();) {
    const auto end = row + static_cast<std::ptrdiff_t>(action_.size());
    std::copy(row, end, action_.begin());
    step_environments();
    for (std::size_t e = 0; e < count_; ++e) {
      if (count_reward(discount, e)) begin_episode(e);
    }
    replayed_.set(environments_);
    row = end;
  }
}

void Rollout::collect(const Frozen& frozen) {
  horizon_ = frozen.pace.horizon();
  actor_row_.resize(frozen.model.actor.row());
  critic_row_.resize(frozen.model.critic.row());
  observation_sums.clear();
  return_sums.clear();
  episodes.clear();
  Stopwatch watch;
  for (std::size_t t = 0; t < horizon_; ++t) {
    note_states(t);
    act(frozen, t);
    spent.inference_s += watch.lap();
    step_environments();
    spent.simulation_s += watch.lap();
    note_step(frozen, t);
    spent.learning_s += watch.lap();
  }
  for (std::size_t k = 0; k < tiles(); ++k) {
    frozen.normaliser.load(observer_.now() + k * kLanes * width_, critic_row_.data());
    critic_states_.load(frozen.model.critic, k, critic_row_.data());
    frozen.model.critic.forward(frozen.kernels, frozen.model.critic_parameters.data(),
                                critic_row_.data());
    note_values(horizon_, k, critic_row_[frozen.model.critic.output()]);
  }
  estimate_advantages(frozen.settings);
  remembered.clear();
  actor_states_.save(remembered);
  critic_states_.save(remembered);
  spent.learning_s += watch.lap();
}

/// Samples the actions of all environments and notes what the critic thinks.
void Rollout::act(const Frozen& frozen, std::size_t step) {
  const Model& model = frozen.model;
  for (std::size_t k = 0; k < tiles(); ++k) {
    frozen.normaliser.load(observer_.now() + k * kLanes * width_, critic_row_.data());
    std::copy_n(critic_row_.data(), observer_.actor_width(), actor_row_.data());
    note_inputs(step, k);
    actor_states_.load(model.actor, k, actor_row_.data());
    critic_states_.load(model.critic, k, critic_row_.data());
    model.actor.forward(frozen.kernels, model.actor_parameters.data(), actor_row_.data());
    model.critic.forward(frozen.kernels, model.critic_parameters.data(), critic_row_.data());
    actor_states_.keep(model.actor, k, actor_row_.data());
    critic_states_.keep(model.critic, k, critic_row_.data());
    Simd* answers = &actor_row_[model.actor.output()];
    if (head_.chooses) {
      sample_choices(frozen, step, k, answers);
    } else {
      frozen.kernels.tanh(answers, head_.outputs);
      sample_actions(frozen, step, k, answers);
    }
    note_values(step, k, critic_row_[model.critic.output()]);
  }
}

Rollout::Place Rollout::place(std::size_t step, std::size_t environment) const {
  const std::size_t sequence = step / sequence_ * count_ + environment;
  return {sequence / kLanes * sequence_ + step % sequence_, sequence % kLanes};
}

/// Inputs of the critic, from its row. Environments of a tile are adjacent in a SIMD vector, too.
void Rollout::note_inputs(std::size_t step, std::size_t tile) {
  const Place to = place(step, tile * kLanes);
  Simd* x = &inputs[to.simd * width_];
  for (std::size_t i = 0; i < width_; ++i)
    std::copy_n(critic_row_[i].lane, lanes(), &x[i].lane[to.lane]);
}

void Rollout::note_values(std::size_t step, std::size_t tile, const Simd& value) {
  std::copy_n(value.lane, lanes(), &value_[step * count_ + tile * kLanes]);
}

/// The random numbers of an environment in one step.
Random Rollout::noise(const Frozen& frozen, std::size_t step, std::size_t environment) const {
  const auto time = static_cast<std::uint32_t>(frozen.pace.time + step);
  return {{frozen.settings.seed, static_cast<std::uint32_t>(first_ + environment), time},
          entity_id("train/noise")};
}

void Rollout::sample_choices(const Frozen& frozen, std::size_t step, std::size_t tile,
                             const Simd* scores) {
  for (std::size_t l = 0; l < lanes(); ++l) {
    const std::size_t e = tile * kLanes + l;
    const Place to = place(step, e);
    Random random = noise(frozen, step, e);
    const Simd* own = scores;
    float log_p = 0.0F;
    for (std::size_t j = 0; j < numbers_; own += head_.counts[j++]) {
      const Choice choice(own, head_.counts[j], l);
      const std::size_t sampled = choice.at(random.uniform(0.0F, 1.0F));
      actions[to.simd * numbers_ + j].lane[to.lane] = static_cast<float>(sampled);
      action_[e * numbers_ + j] = head_.low[j] + static_cast<float>(sampled);
      log_p += choice.log_probability(sampled);
    }
    log_probability[to.simd].lane[to.lane] = log_p;
  }
}

void Rollout::sample_actions(const Frozen& frozen, std::size_t step, std::size_t tile,
                             const Simd* means) {
  for (std::size_t l = 0; l < lanes(); ++l) {
    const std::size_t e = tile * kLanes + l;
    const Place to = place(step, e);
    Random random = noise(frozen, step, e);
    float log_p = 0.0F;
    for (std::size_t j = 0; j < numbers_; ++j) {
      const float noise = random.normal(0.0F, 1.0F);
      const float x = means[j].lane[l] + frozen.deviation[j] * noise;
      actions[to.simd * numbers_ + j].lane[to.lane] = x;
      action_[e * numbers_ + j] = head_.scaled(j, x);
      log_p += -0.5F * noise * noise - frozen.model.log_deviation[j] - kHalfLogTwoPi;
    }
    log_probability[to.simd].lane[to.lane] = log_p;
  }
}

void Rollout::step_environments() {
  step_all(environments_, action_.data(), rows_);
  observer_.look(environments_);
  observer_.look_at_ends(environments_);
  cut_first_episodes();
}

void Rollout::note_step(const Frozen& frozen, std::size_t step) {
  if (remembers) taken.insert(taken.end(), action_.begin(), action_.end());
  for (std::size_t e = 0; e < count_; ++e) record_step(frozen, step, e);
  replayed_.set(environments_);
  bootstrap(frozen, step);
  forget();
  sum_observations();
}

/// Gradients go back to here.
void Rollout::note_states(std::size_t step) {
  if (actor_states_.width() == 0 || step % sequence_ != 0) return;
  for (std::size_t e = 0; e < count_; ++e) {
    const Place to = place(step, e);
    const std::size_t first = to.simd / sequence_ * actor_states_.width();
    actor_states_.copy(e, &actor_starts[first], to.lane);
    critic_states_.copy(e, &critic_starts[first], to.lane);
  }
}

/// Nothing of an episode is remembered in the next one.
void Rollout::forget() {
  for (std::size_t e = 0; e < count_; ++e) {
    if (!rows_.ended(e)) continue;
    actor_states_.forget(e);
    critic_states_.forget(e);
  }
}

void Rollout::recall(const float* states) {
  critic_states_.restore(actor_states_.restore(states));
}

/// Whether it was the last of the episode.
bool Rollout::count_reward(float discount, std::size_t environment) {
  const std::size_t e = environment;
  return_[e] += rows_.reward[e];
  discounted_[e] = discounted_[e] * discount + rows_.reward[e];
  return rows_.ended(e);
}

void Rollout::begin_episode(std::size_t environment) {
  return_[environment] = 0.0;
  discounted_[environment] = 0.0F;
  replayed_.note(environment);
}

/// Counts the reward and the end of an episode.
void Rollout::record_step(const Frozen& frozen, std::size_t step, std::size_t environment) {
  const std::size_t e = environment;
  const bool ended = count_reward(frozen.settings.gamma, e);
  return_sums.add(0, discounted_[e]);
  rewards_[step * count_ + e] = rows_.reward[e] * frozen.reward_scale;
  const Place to = place(step, e);
  continues[to.simd].lane[to.lane] = ended ? 0.0F : 1.0F;
  if (!ended) return;
  if (is_cut_[e] == 0)
    episodes.push_back(
        {return_[e], static_cast<std::uint32_t>(step), rows_.success[e] != 0 ? 1U : 0U});
  begin_episode(e);
}

/// An episode that only ran out of time would have gone on: the critic says how.
void Rollout::bootstrap(const Frozen& frozen, std::size_t step) {
  const Model& model = frozen.model;
  for (std::size_t k = 0; k < tiles(); ++k) {
    bool any = false;
    for (std::size_t e = k * kLanes; e < k * kLanes + lanes(); ++e) {
      any = any || (rows_.truncated[e] != 0 && rows_.terminated[e] == 0);
    }
    if (!any) continue;
    frozen.normaliser.load(observer_.at_end() + k * kLanes * width_, critic_row_.data());
    critic_states_.load(model.critic, k, critic_row_.data());
    model.critic.forward(frozen.kernels, model.critic_parameters.data(), critic_row_.data());
    const Simd& value = critic_row_[model.critic.output()];
    for (std::size_t l = 0; l < lanes(); ++l) {
      const std::size_t e = k * kLanes + l;
      if (rows_.truncated[e] == 0 || rows_.terminated[e] != 0) continue;
      rewards_[step * count_ + e] += frozen.settings.gamma * value.lane[l];
    }
  }
}

void Rollout::sum_observations() {
  for (std::size_t e = 0; e < count_; ++e) {
    for (std::size_t i = 0; i < width_; ++i) {
      const float x = observer_.now()[e * width_ + i];
      if (!std::isfinite(x)) {
        throw Problem(kProblems, "an observation is NaN or infinite",
                      "the simulation breaks down: look at its step, or end the episode sooner");
      }
      observation_sums.add(i, x);
    }
  }
  const auto count = static_cast<double>(count_);
  observation_sums.count += count;
  return_sums.count += count;
}

/// Generalised advantage estimation (Schulman et al. 2016), from the last step back.
void Rollout::estimate_advantages(const Settings& settings) {
  const float gamma = settings.gamma;
  advantage_sums.clear();
  for (std::size_t e = 0; e < count_; ++e) {
    float sum = 0.0F;
    for (std::size_t t = horizon_; t-- > 0;) {
      const std::size_t sample = t * count_ + e;
      const Place at = place(t, e);
      const float goes = continues[at.simd].lane[at.lane];
      const float value = value_[sample], next = value_[sample + count_];
      const float surprise = rewards_[sample] + gamma * goes * next - value;
      sum = surprise + gamma * settings.gae_lambda * goes * sum;
      advantage[at.simd].lane[at.lane] = sum;
      target[at.simd].lane[at.lane] = sum + value;
      advantage_sums.add(0, sum);
    }
  }
  advantage_sums.count = static_cast<double>(count_ * horizon_);
}

}  // namespace eagerx::train
