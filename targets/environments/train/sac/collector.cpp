#include "targets/environments/train/sac/collector.hpp"

#include <algorithm>
#include <cmath>
#include <eagerx/math.hpp>

#include "targets/environments/train/sac/squashed.hpp"

namespace eagerx::train::sac {

Collector::Collector(const train::Settings& settings, const Library& library, std::uint32_t longest)
    : observation_sums(library.description().observation_numbers() +
                       library.description().critic_numbers()),
      return_sums(1),
      reward_sums(2),
      settings_(settings),
      head_(library.description()),
      environments_(library.functions(), static_cast<std::uint32_t>(settings.sac.n_envs), 0,
                    settings.seed, longest, EAGERX_SAME_STEP),
      count_(settings.sac.n_envs),
      numbers_(head_.numbers),
      replayed_(settings, library, 0, static_cast<std::uint32_t>(count_)),
      rows_(library.description(), count_),
      observer_(library.description(), rows_),
      width_(observer_.width()),
      squashed_(count_ * numbers_),
      action_(count_ * numbers_),
      return_(count_),
      discounted_(count_) {
  rows_.final_observation = rows_.observation;
  rows_.observation.resize(kLanes * observer_.actor_width());
}

void Collector::reset(std::uint64_t seed) {
  replayed_.reset(environments_, seed, rows_.observation.data());
  observer_.look(environments_);
  return_.assign(count_, 0.0);
  discounted_.assign(count_, 0.0F);
  observation_sums.clear();
  sum_observations();
}

Random Collector::noise(std::uint32_t time, std::size_t environment) const {
  return {{settings_.seed, static_cast<std::uint32_t>(environment), time},
          entity_id("train/noise")};
}

void Collector::act(const Model& model, const Normaliser& normaliser, const Kernels& kernels,
                    std::uint32_t time) {
  row_.resize(model.actor.row());
  seen_.resize(width_);
  normaliser.load(observer_.now(), seen_.data());
  std::copy_n(seen_.begin(), observer_.actor_width(), row_.begin());
  model.actor.forward(kernels, model.actor_parameters.data(), row_.data());
  Simd* means = &row_[model.actor.output()];
  kernels.tanh(means + numbers_, numbers_);
  for (std::size_t e = 0; e < count_; ++e) {
    Random random = noise(time, e);
    for (std::size_t j = 0; j < numbers_; ++j) {
      const float deviation = exp(log_deviation_of(means[numbers_ + j].lane[e]));
      squashed_[e * numbers_ + j] = tanh(means[j].lane[e] + deviation * random.normal(0.0F, 1.0F));
    }
  }
}

void Collector::step(Model& model, const Normaliser& normaliser, const Kernels& kernels,
                     bool is_random, std::uint32_t time) {
  Stopwatch watch;
  if (!is_random) act(model, normaliser, kernels, time);
  for (std::size_t e = 0; e < count_ && is_random; ++e) {
    Random random = noise(time, e);
    for (std::size_t j = 0; j < numbers_; ++j)
      squashed_[e * numbers_ + j] = random.uniform(-1.0F, 1.0F);
  }
  before_.assign(observer_.now(), observer_.now() + count_ * width_);
  spent.inference_s += watch.lap();
  step_environments();
  spent.simulation_s += watch.lap();
  for (std::size_t e = 0; e < count_; ++e) record_step(model, e, time);
  replayed_.set(environments_);
  sum_observations();
  spent.learning_s += watch.lap();
}

void Collector::step_again(const Memory& memory, std::size_t back) {
  for (std::size_t e = 0; e < count_; ++e) {
    std::copy_n(memory.last(back - e).action, numbers_, &squashed_[e * numbers_]);
  }
  step_environments();
  for (std::size_t e = 0; e < count_; ++e) count_reward(e);
  replayed_.set(environments_);
}

void Collector::step_environments() {
  for (std::size_t i = 0; i < action_.size(); ++i)
    action_[i] = head_.scaled(i % numbers_, squashed_[i]);
  step_all(environments_, action_.data(), rows_);
  observer_.look(environments_);
  observer_.look_at_ends(environments_);
}

/// Whether it was the last of the episode, whose return is then in `return_` for the last time.
bool Collector::count_reward(std::size_t environment) {
  const std::size_t e = environment;
  const bool ended = rows_.ended(e);
  return_[e] += rows_.reward[e];
  discounted_[e] = discounted_[e] * settings_.gamma + rows_.reward[e];
  return_sums.add(0, discounted_[e]);
  reward_sums.add(0, rows_.reward[e]);
  reward_sums.add(1, rows_.terminated[e] != 0 ? 0.0 : 1.0);
  if (!ended) return false;
  episodes.push_back({return_[e], 0, rows_.success[e] != 0 ? 1U : 0U});
  return_[e] = 0.0;
  discounted_[e] = 0.0F;
  replayed_.note(e);
  return true;
}

void Collector::record_step(Model& model, std::size_t environment, std::uint32_t time) {
  const std::size_t e = environment;
  const bool ended = count_reward(e);
  if (ended) episodes.back().step = time;
  model.memory.add(
      {&before_[e * width_], (ended ? observer_.at_end() : observer_.now()) + e * width_,
       &squashed_[e * numbers_], rows_.reward[e], rows_.terminated[e] != 0 ? 0.0F : 1.0F});
}

void Collector::sum_observations() {
  for (std::size_t i = 0; i < count_ * width_; ++i) {
    if (!std::isfinite(observer_.now()[i])) {
      throw Problem(kProblems, "an observation is NaN or infinite",
                    "the simulation breaks down: look at its step, or end the episode sooner");
    }
    observation_sums.add(i % width_, observer_.now()[i]);
  }
  observation_sums.count += static_cast<double>(count_);
  return_sums.count += static_cast<double>(count_);
  reward_sums.count += static_cast<double>(count_);
}

}  // namespace eagerx::train::sac
