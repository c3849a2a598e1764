#include "targets/environments/train/ppo.hpp"

#include <algorithm>
#include <cmath>
#include <eagerx/math.hpp>
#include <optional>
#include <utility>

#include "targets/environments/train/checkpoint.hpp"
#include "targets/environments/train/ranks/together.hpp"

namespace eagerx::train {
namespace {

/// The factor that makes the gradient of a mean of sums at most `longest` long.
float clipped_scale(const std::vector<float>& gradient, double count, double longest) {
  double squares = 0.0;
  for (const float g : gradient) squares += double{g} * g;
  const double length = std::sqrt(squares) / count;
  return static_cast<float>((length > longest ? longest / length : 1.0) / count);
}

}  // namespace

float share_of_actor(const Settings& settings, std::uint32_t iteration) {
  if (settings.ema_decay == 0.0F) return 1.0F;
  const auto so_far = static_cast<float>(iteration);
  // At first the mean of all so far: the first actor knows nothing and is forgotten soon.
  const float first = 2.0F / (so_far + 2.0F);
  const float tail = max(1.0F, settings.ema_window_fraction * so_far);
  return max(min(1.0F - settings.ema_decay, 1.0F / tail), first);
}

Ppo::Ppo(const Settings& settings, const Library& library, const Kernels& kernels, ThreadPool& pool,
         std::uint32_t longest, Ranks& ranks)
    : Algorithm(pace_of(settings, library.description())),
      settings_(settings),
      head_(library.description()),
      model_(settings, library.description().observation_numbers(), head_,
             library.description().critic_numbers()),
      critic_(critic_of(library.description())),
      kernels_(kernels),
      pool_(pool),
      ranks_(ranks),
      own_(environments::share_of(kParts, ranks.rank(), ranks.size())),
      has_threads_(library.description().has_threads),
      gradient_sum_(ranks, model_),
      learning_s_(own_.end - own_.first) {
  done_.weights = model_.actor.parameters() + model_.critic.parameters();
  for (std::size_t part = 0; part < kParts; ++part) {
    if (part < own_.first || part >= own_.end) {
      parts_.push_back(std::make_unique<RolloutStatistics>(model_.critic.inputs()));
      continue;
    }
    parts_.push_back(std::make_unique<Rollout>(settings_, library, head_, longest, part));
    learners_.push_back(std::make_unique<PpoLearner>(settings_, model_));
  }
}

void Ppo::set_stage(const std::string& name) {
  for (std::size_t part = own_.first; part < own_.end; ++part) rollout(part).set_stage(name);
}

void Ppo::begin_era() {
  const std::uint64_t seed = settings_.seed + (std::uint64_t{pace.era} << 32U);
  for (auto& part : parts_) part->taken.clear();
  in_parts([&](std::size_t part) { rollout(part).reset(seed); });
  if (model_.observations.count > 0.0 || !settings_.norm_obs) return;
  for (auto& part : parts_) model_.observations.add(part->observation_sums);
}

void Ppo::in_parts(const std::function<void(std::size_t part)>& work) {
  share_seen(ranks_, parts_, [&] {
    const auto one = [&](std::size_t i) { work(own_.first + i); };
    if (has_threads_) return pool_.run_parts(own_.end - own_.first, one);
    for (std::size_t i = 0; i < own_.end - own_.first; ++i) one(i);
  });
}

void Ppo::remember_actions() {
  remembers_ = true;
  for (std::size_t part = own_.first; part < own_.end; ++part) rollout(part).remembers = true;
}

std::size_t Ppo::actions_of_part() const {
  return pace.since_era * settings_.n_envs * head_.numbers / kParts;
}

std::vector<float> Ppo::actions() const {
  std::vector<float> actions;
  for (const auto& part : parts_) {
    const std::size_t count = std::min(actions_of_part(), part->taken.size());
    actions.insert(actions.end(), part->taken.begin(),
                   part->taken.begin() + static_cast<std::ptrdiff_t>(count));
  }
  return actions;
}

void Ppo::take_up(const std::vector<float>& actions) {
  const std::size_t count = actions_of_part();
  if (actions.size() != count * kParts) return;
  for (std::size_t part = 0; part < kParts; ++part) {
    const auto first = actions.begin() + static_cast<std::ptrdiff_t>(part * count);
    parts_[part]->taken.assign(first, first + static_cast<std::ptrdiff_t>(count));
  }
}

void Ppo::go_on() {
  std::vector<std::vector<float>> taken;
  for (auto& part : parts_) taken.push_back(std::exchange(part->taken, {}));
  const bool has_actions = !taken.front().empty();
  begin_era();
  for (std::size_t part = 0; part < kParts && remembers_; ++part) parts_[part]->taken = taken[part];
  in_parts([&](std::size_t part) {
    rollout(part).replay(taken[part], settings_.gamma);
    const std::size_t states = model_.remembered.size() / kParts;
    if (has_actions) rollout(part).recall(model_.remembered.data() + part * states);
  });
}

std::vector<Episode> Ppo::collect() {
  Frozen frozen{kernels_, settings_, model_, Normaliser(model_.observations), {}, 1.0F, pace};
  for (const float x : model_.log_deviation) frozen.deviation.push_back(exp(x));
  frozen.reward_scale = static_cast<float>(model_.returns.scale(0));
  in_parts([&](std::size_t part) { rollout(part).collect(frozen); });
  std::vector<Episode> episodes;
  Sums advantages(1);
  for (const auto& part : parts_) {
    advantages.sum[0] += part->advantage_sums.sum[0];
    advantages.squares[0] += part->advantage_sums.squares[0];
    advantages.count += part->advantage_sums.count;
    episodes.insert(episodes.end(), part->episodes.begin(), part->episodes.end());
  }
  std::ranges::stable_sort(episodes, {}, &Episode::step);
  const double mean = advantages.sum[0] / advantages.count;
  const double variance = advantages.squares[0] / advantages.count - mean * mean;
  advantage_mean_ = static_cast<float>(mean);
  advantage_scale_ = static_cast<float>(1.0 / std::sqrt(std::max(variance, 0.0) + 1e-8));
  return episodes;
}

/// The inputs that the networks learn from keep the previous statistics, which change when that is
/// over.
void Ppo::see() {
  if (is_frozen()) return;
  const double scale = model_.returns.scale(0);
  for (auto& part : parts_) model_.returns.add(part->return_sums);
  const auto ratio = static_cast<float>(model_.returns.scale(0) / scale);
  const Network::Layer& last = model_.critic.layers().back();
  for (std::size_t i = last.weights; i < last.bias + last.sizes.outputs; ++i)
    model_.critic_parameters[i] *= ratio;
  if (!settings_.norm_obs) return;
  const Statistics before = model_.observations;
  for (auto& part : parts_) model_.observations.add(part->observation_sums);
  keep_answers(model_.critic, model_.critic_parameters, before, model_.observations);
  for (auto* parameters : {&model_.actor_parameters, &model_.averaged})
    keep_answers(model_.actor, *parameters, before, model_.observations);
}

bool Ppo::is_frozen() const {
  return settings_.freeze_after > 0.0 && static_cast<double>(steps()) >= settings_.freeze_after;
}

float Ppo::decay() const {
  return settings_.decay(steps());
}

/// Once an iteration: the first minibatches do not diverge whatever the step is, and a step that
/// followed each of them would swing between its bounds.
void Ppo::adapt_step_size() {
  if (settings_.schedule == Schedule::constant) {
    model_.step_size = settings_.learning_rate * decay();
    return;
  }
  constexpr float kFactor = 1.5F;
  const double wanted = settings_.target_kl * decay();
  if (divergence_ > 2.0 * wanted) model_.step_size /= kFactor;
  if (divergence_ < 0.5 * wanted) model_.step_size *= kFactor;
  model_.step_size =
      clamp(model_.step_size, settings_.min_learning_rate, settings_.max_learning_rate);
}

void Ppo::average() {
  if (settings_.ema_decay == 0.0F) {
    model_.averaged = model_.actor_parameters;
    return;
  }
  const float share = share_of_actor(settings_, pace.iteration);
  for (std::size_t i = 0; i < model_.averaged.size(); ++i)
    model_.averaged[i] += share * (model_.actor_parameters[i] - model_.averaged[i]);
}

/// Learns from every Mth tile, from `minibatch` on.
bool Ppo::update(std::size_t minibatch) {
  precision_.clear();
  for (const float x : model_.log_deviation) precision_.push_back(exp(-x));
  const PpoUpdate common{.settings = settings_,
                         .head = head_,
                         .model = model_,
                         .kernels = kernels_,
                         .precision = precision_,
                         .advantage_mean = advantage_mean_,
                         .advantage_scale = advantage_scale_,
                         .minibatches = minibatches()};
  pool_.run_parts(learners_.size(), [&](std::size_t i) {
    const Stopwatch watch;
    learners_[i]->learn(common, rollout(own_.first + i), minibatch);
    learning_s_[i] += watch.seconds();
  });
  done_.samples += settings_.n_envs * pace.horizon() / minibatches() * own() / kParts;
  const Stopwatch watch;
  const bool continues = move();
  updating_s_ += watch.seconds();
  return continues;
}

/// Along the gradients of all parts. False if the policy has moved far enough.
bool Ppo::move() {
  std::vector<Gradient*> own;
  for (const auto& learner : learners_) own.push_back(&learner->gradient);
  const Gradient& sum = gradient_sum_.of(own);
  divergence_ = sum.divergence / sum.count;
  if (settings_.kl_stop_factor > 0.0F &&
      divergence_ > double{settings_.kl_stop_factor} * settings_.target_kl * decay())
    return false;
  model_.actor_adam.step(kernels_, model_.actor_parameters, sum.actor, model_.step_size,
                         clipped_scale(sum.actor, sum.count, settings_.max_grad_norm));
  model_.critic_adam.step(kernels_, model_.critic_parameters, sum.critic, model_.step_size,
                          clipped_scale(sum.critic, sum.count, settings_.max_grad_norm));
  model_.deviation_adam.step(kernels_, model_.log_deviation, sum.log_deviation,
                             settings_.std_learning_rate_ratio * model_.step_size,
                             static_cast<float>(1.0 / sum.count));
  for (float& x : model_.log_deviation) {
    x = clamp(x, log(settings_.min_std), log(settings_.max_std));
  }
  return true;
}

/// Of this iteration: each has a SIMD vector of each part, or sixteen sequences.
std::size_t Ppo::minibatches() const {
  const std::size_t steps = model_.actor.memory() == nullptr ? 1 : settings_.bptt_steps;
  const std::size_t samples = settings_.n_envs * pace.horizon();
  return std::min(settings_.n_minibatches, samples / (kParts * kLanes * steps));
}

std::size_t Ppo::learn() {
  constexpr std::size_t kShift = 7;  // the minibatches of an epoch do not begin with the same one
  const std::size_t count = minibatches(), most = settings_.n_epochs * count;
  std::size_t updates = 0;
  for (; updates < most; ++updates) {
    const std::size_t epoch = updates / count, m = updates % count;
    if (!update((epoch * kShift + m) % count)) break;
  }
  return updates;
}

Algorithm::Result Ppo::iterate() {
  Result result{collect()};
  const std::optional<Model> before = ranks_.size() > 1 ? std::optional(model_) : std::nullopt;
  try {
    result.updates = learn();
    adapt_step_size();
  } catch (const Problem&) {  // another rank is gone: there is a checkpoint to be written
    if (before) model_ = *before;
    throw;
  }
  const Stopwatch watch;
  average();
  see();
  updating_s_ += watch.seconds();
  done_.steps += settings_.n_envs * pace.horizon() * own() / kParts;
  model_.remembered.clear();
  for (const auto& part : parts_)
    model_.remembered.insert(model_.remembered.end(), part->remembered.begin(),
                             part->remembered.end());
  pace.next();
  result.divergence = divergence_;
  return result;
}

std::vector<float> Ppo::deployed_parameters() const {
  return folded(model_.actor, model_.averaged, model_.observations);
}

Spent Ppo::spent() const {
  Spent sum{.learning_s = updating_s_};
  for (std::size_t i = 0; i < own(); ++i) {
    sum += rollout(own_.first + i).spent;
    sum.learning_s += learning_s_[i];
  }
  return sum;
}

double Ppo::deviation() const {
  double deviation = 0.0;
  for (const float x : model_.log_deviation) deviation += exp(x);
  return deviation / static_cast<double>(model_.log_deviation.size());
}

std::string Ppo::checkpoint(const std::string& conditions, const std::string& interface,
                            Progressed& progressed) const {
  if (!progressed.succeeded) progressed.actions = actions();
  std::string bytes = checkpoint_of(conditions + critic_, interface + critic_, model_, progressed);
  progressed.actions = {};
  return bytes;
}

void Ppo::restore(const std::string& bytes, const std::string& name, const std::string& conditions,
                  Progressed& progressed) {
  train::restore(bytes, name, conditions + critic_, model_, progressed);
  pace.go_to(progressed.iteration, progressed.curriculum);
  // After a change of the task eras may be longer: then the rest of this one has new episodes.
  take_up(std::exchange(progressed.actions, {}));
}

std::string Ppo::replay(const std::string& /*text*/, const std::string& name) {
  throw Problem(kUsage, "PPO learns from its own steps only, and not from `" + name + "`",
                "`--algorithm sac` does");
}

void Ppo::begin_from(const std::string& bytes, const std::string& name,
                     const std::string& interface) {
  train::begin_from(bytes, name, interface + critic_, model_);
}

}  // namespace eagerx::train
