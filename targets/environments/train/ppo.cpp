#include "targets/environments/train/ppo.hpp"

#include <algorithm>
#include <cmath>
#include <eagerx/math.hpp>
#include <optional>
#include <utility>

#include "targets/environments/train/checkpoint.hpp"
#include "targets/environments/train/choice.hpp"
#include "targets/environments/train/ranks/together.hpp"

namespace eagerx::train {
namespace {

/// What makes the gradient of a mean of sums at most `longest` long.
float clipped_scale(const std::vector<float>& gradient, double count, double longest) {
  double squares = 0.0;
  for (const float g : gradient) squares += double{g} * g;
  const double length = std::sqrt(squares) / count;
  return static_cast<float>((length > longest ? longest / length : 1.0) / count);
}

}  // namespace

float share_of_actor(const Settings& settings, std::uint32_t iteration) {
  if (settings.averaging == 0.0F) return 1.0F;
  const auto so_far = static_cast<float>(iteration);
  // At first the mean of all so far: the first actor knows nothing and is forgotten soon.
  const float first = 2.0F / (so_far + 2.0F);
  const float tail = max(1.0F, settings.averaging_share * so_far);
  return max(min(1.0F - settings.averaging, 1.0F / tail), first);
}

/// The gradient of every Mth tile of one rollout; with a memory, of every Mth sequence of them.
class Ppo::Learner {
 public:
  Learner(const Settings& settings, const Model& model)
      : gradient(model),
        block_(model.actor.memory() == nullptr ? kBlock : settings.memory_steps),
        actor_rows_(block_ * model.actor.row()),
        actor_deltas_(block_ * model.actor.row()),
        critic_rows_(block_ * model.critic.row()),
        critic_deltas_(block_ * model.critic.row()),
        scratch_(block_ * kLanes),
        goes_on_(block_) {}

  Gradient gradient;

  void learn(const Ppo& ppo, const Rollout& rollout, std::size_t first) {
    gradient.clear();
    const Model& model = ppo.model_;
    const std::size_t steps = model.actor.memory() == nullptr ? 1 : block_;
    const std::size_t sequences = rollout.packs() / steps;
    std::size_t tiles = 0;
    for (std::size_t s = first; s < sequences; s += ppo.minibatches()) {
      for (std::size_t t = 0; t < steps; ++t) {
        if (model.actor.memory() != nullptr) recall(model, rollout, s, t);
        evaluate(ppo, rollout, s * steps + t, tiles);
        if (++tiles == block_) backward(ppo.kernels_, model, std::exchange(tiles, 0));
      }
    }
    backward(ppo.kernels_, model, tiles);
  }

 private:
  static constexpr std::size_t kBlock = 8;  // tiles whose rows fit into the cache

  /// What is remembered before step `t` of sixteen sequences.
  void recall(const Model& model, const Rollout& rollout, std::size_t sequence, std::size_t t) {
    std::fill_n(goes_on_[t].lane, kLanes, 1.0F);
    if (t > 0) goes_on_[t] = rollout.goes_on[sequence * block_ + t - 1];
    const auto from = [&](const Network& network, const Packs& starts, Packs& rows) {
      Pack* row = &rows[t * network.row()];
      const Pack* state = t > 0 ? row - network.row() + network.memory()->after()
                                : &starts[sequence * network.memory()->shape().state()];
      train::recall(network, goes_on_[t], state, row);
    };
    from(model.actor, rollout.actor_starts, actor_rows_);
    from(model.critic, rollout.critic_starts, critic_rows_);
  }

  void evaluate(const Ppo& ppo, const Rollout& rollout, std::size_t tile, std::size_t place) {
    const Model& model = ppo.model_;
    const std::size_t width = model.critic.inputs();
    Pack* actor = &actor_rows_[place * model.actor.row()];
    Pack* critic = &critic_rows_[place * model.critic.row()];
    std::copy_n(&rollout.inputs[tile * width], model.actor.inputs(), actor);
    std::copy_n(&rollout.inputs[tile * width], width, critic);
    model.actor.forward(ppo.kernels_, model.actor_parameters.data(), actor);
    model.critic.forward(ppo.kernels_, model.critic_parameters.data(), critic);
    Pack* answers = actor + model.actor.output();
    Pack* deltas = &actor_deltas_[place * model.actor.row() + model.actor.output()];
    if (ppo.head_.chooses) {
      for (std::size_t l = 0; l < kLanes; ++l) choice_loss(ppo, rollout, tile, l, answers, deltas);
    } else {
      ppo.kernels_.tanh(answers, model.actor.outputs());
      for (std::size_t l = 0; l < kLanes; ++l) actor_loss(ppo, rollout, tile, l, answers, deltas);
      ppo.kernels_.tanh_slope(answers, deltas, model.actor.outputs());
    }
    const Pack& value = critic[model.critic.output()];
    Pack& delta = critic_deltas_[place * model.critic.row() + model.critic.output()];
    for (std::size_t l = 0; l < kLanes; ++l) {
      delta.lane[l] = value.lane[l] - rollout.target[tile].lane[l];
    }
  }

  /// Derivatives of the clipped loss of one sample by the means and the logarithms of the
  /// deviations.
  void actor_loss(const Ppo& ppo, const Rollout& rollout, std::size_t tile, std::size_t l,
                  const Pack* means, Pack* deltas) {
    const Model& model = ppo.model_;
    const std::size_t outputs = model.log_deviation.size();
    const Pack* actions = &rollout.actions[tile * outputs];
    const auto distance = [&](std::size_t j) {  // from the mean, in deviations
      return (actions[j].lane[l] - means[j].lane[l]) * ppo.precision_[j];
    };
    float log_p = 0.0F;
    for (std::size_t j = 0; j < outputs; ++j) {
      const float z = distance(j);
      log_p += -0.5F * z * z - model.log_deviation[j] - kHalfLogTwoPi;
    }
    const float slope = clipped_slope(ppo, rollout, tile, l, log_p);
    for (std::size_t j = 0; j < outputs; ++j) {
      const float z = distance(j);
      deltas[j].lane[l] = slope * z * ppo.precision_[j];
      gradient.log_deviation[j] += slope * (z * z - 1.0F);
    }
  }

  /// The same for choices, by their scores. A choice that is nearly certain is not tried again: the
  /// entropy keeps it from becoming so too soon.
  void choice_loss(const Ppo& ppo, const Rollout& rollout, std::size_t tile, std::size_t l,
                   const Pack* scores, Pack* deltas) {
    const Head& head = ppo.head_;
    const Pack* actions = &rollout.actions[tile * head.numbers];
    const auto chosen = [&](std::size_t j) { return static_cast<std::size_t>(actions[j].lane[l]); };
    choices_.clear();
    float log_p = 0.0F;
    for (std::size_t j = 0; j < head.numbers; scores += head.counts[j++]) {
      choices_.emplace_back(scores, head.counts[j], l);
      log_p += choices_.back().log_probability(chosen(j));
    }
    const float slope = clipped_slope(ppo, rollout, tile, l, log_p);
    for (std::size_t j = 0; j < head.numbers; deltas += head.counts[j++]) {
      const Choice& choice = choices_[j];
      for (std::size_t i = 0; i < head.counts[j]; ++i) {
        const float p = choice.probability(i);
        const float surprise = choice.log_probability(i) + choice.entropy();
        deltas[i].lane[l] =
            slope * ((i == chosen(j) ? 1.0F : 0.0F) - p) + ppo.settings_.entropy * p * surprise;
      }
    }
  }

  /// The derivative of the clipped loss of one sample by the logarithm of its probability.
  float clipped_slope(const Ppo& ppo, const Rollout& rollout, std::size_t tile, std::size_t l,
                      float log_p) {
    const float log_ratio = clamp(log_p - rollout.log_probability[tile].lane[l], -10.0F, 10.0F);
    const float ratio = exp(log_ratio);
    const float advantage =
        (rollout.advantage[tile].lane[l] - ppo.advantage_mean_) * ppo.advantage_scale_;
    const float clip = ppo.settings_.clip;
    const bool counts = advantage > 0.0F ? ratio < 1.0F + clip : ratio > 1.0F - clip;
    gradient.divergence += double{ratio} - 1.0 - log_ratio;  // Schulman 2020, never negative
    gradient.count += 1.0;
    return counts ? -advantage * ratio : 0.0F;
  }

  void backward(const Kernels& kernels, const Model& model, std::size_t tiles) {
    if (tiles == 0) return;
    model.actor.backward(kernels, model.actor_parameters.data(), actor_rows_.data(),
                         actor_deltas_.data(), tiles, scratch_.data(), gradient.actor.data(),
                         goes_on_.data());
    model.critic.backward(kernels, model.critic_parameters.data(), critic_rows_.data(),
                          critic_deltas_.data(), tiles, scratch_.data(), gradient.critic.data(),
                          goes_on_.data());
  }

  const std::size_t block_;                                        // tiles that are learnt at once
  Packs actor_rows_, actor_deltas_, critic_rows_, critic_deltas_;  // [block_][row]
  Packs scratch_;
  Packs goes_on_;                // [block_] of a sequence
  std::vector<Choice> choices_;  // of one sample
};

Ppo::Ppo(const Settings& settings, const Library& library, const Kernels& kernels, Team& team,
         std::uint32_t longest, Ranks& ranks)
    : Algorithm(pace_of(settings, library.description())),
      settings_(settings),
      head_(library.description()),
      model_(settings, library.description().observation_numbers(), head_,
             library.description().critic_numbers()),
      critic_(critic_of(library.description())),
      kernels_(kernels),
      team_(team),
      ranks_(ranks),
      own_(environments::share_of(kParts, ranks.rank(), ranks.size())),
      has_threads_(library.description().has_threads),
      gradient_sum_(ranks, model_) {
  for (std::size_t part = 0; part < kParts; ++part) {
    if (part < own_.first || part >= own_.end) {
      parts_.push_back(std::make_unique<Seen>(model_.critic.inputs()));
      continue;
    }
    parts_.push_back(std::make_unique<Rollout>(settings_, library, head_, longest, part));
    learners_.push_back(std::make_unique<Learner>(settings_, model_));
  }
}

Ppo::~Ppo() = default;

void Ppo::set_stage(const std::string& name) {
  for (std::size_t part = own_.first; part < own_.end; ++part) rollout(part).set_stage(name);
}

void Ppo::begin_era() {
  const std::uint64_t seed = settings_.seed + (std::uint64_t{pace.era} << 32U);
  for (auto& part : parts_) part->taken.clear();
  in_parts([&](std::size_t part) { rollout(part).reset(seed); });
  if (model_.observations.count > 0.0 || !settings_.normalise) return;
  for (auto& part : parts_) model_.observations.add(part->observation_sums);
}

void Ppo::in_parts(const std::function<void(std::size_t part)>& work) {
  share_seen(ranks_, parts_, [&] {
    const auto one = [&](std::size_t i) { work(own_.first + i); };
    if (has_threads_) return team_.run_parts(own_.end - own_.first, one);
    for (std::size_t i = 0; i < own_.end - own_.first; ++i) one(i);
  });
}

void Ppo::remember_actions() {
  remembers_ = true;
  for (std::size_t part = own_.first; part < own_.end; ++part) rollout(part).remembers = true;
}

std::size_t Ppo::actions_of_part() const {
  return pace.since_era * settings_.environments * head_.numbers / kParts;
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
    rollout(part).replay(taken[part], settings_.discount);
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

/// What the networks have learnt from is normalised by the statistics of before: they change when
/// that is over.
void Ppo::see() {
  if (is_frozen()) return;
  const double scale = model_.returns.scale(0);
  for (auto& part : parts_) model_.returns.add(part->return_sums);
  const auto ratio = static_cast<float>(model_.returns.scale(0) / scale);
  const Network::Layer& last = model_.critic.layers().back();
  for (std::size_t i = last.weights; i < last.bias + last.sizes.outputs; ++i)
    model_.critic_parameters[i] *= ratio;
  if (!settings_.normalise) return;
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
  const double wanted = settings_.divergence * decay();
  if (divergence_ > 2.0 * wanted) model_.step_size /= kFactor;
  if (divergence_ < 0.5 * wanted) model_.step_size *= kFactor;
  model_.step_size =
      clamp(model_.step_size, settings_.least_learning_rate, settings_.most_learning_rate);
}

void Ppo::average() {
  if (settings_.averaging == 0.0F) {
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
  team_.run_parts(learners_.size(), [&](std::size_t i) {
    learners_[i]->learn(*this, rollout(own_.first + i), minibatch);
  });
  std::vector<Gradient*> own;
  for (const auto& learner : learners_) own.push_back(&learner->gradient);
  const Gradient& sum = gradient_sum_.of(own);
  divergence_ = sum.divergence / sum.count;
  if (settings_.stop_divergence > 0.0F &&
      divergence_ > double{settings_.stop_divergence} * settings_.divergence * decay())
    return false;
  model_.actor_adam.step(kernels_, model_.actor_parameters, sum.actor, model_.step_size,
                         clipped_scale(sum.actor, sum.count, settings_.gradient_norm));
  model_.critic_adam.step(kernels_, model_.critic_parameters, sum.critic, model_.step_size,
                          clipped_scale(sum.critic, sum.count, settings_.gradient_norm));
  model_.deviation_adam.step(kernels_, model_.log_deviation, sum.log_deviation,
                             settings_.deviation_rate * model_.step_size,
                             static_cast<float>(1.0 / sum.count));
  for (float& x : model_.log_deviation) {
    x = clamp(x, log(settings_.least_deviation), log(settings_.most_deviation));
  }
  return true;
}

/// Of this iteration: each has a pack of each part, or sixteen sequences.
std::size_t Ppo::minibatches() const {
  const std::size_t steps = model_.actor.memory() == nullptr ? 1 : settings_.memory_steps;
  const std::size_t samples = settings_.environments * pace.horizon();
  return std::min(settings_.minibatches, samples / (kParts * kLanes * steps));
}

std::size_t Ppo::learn() {
  constexpr std::size_t kShift = 7;  // the minibatches of an epoch do not begin with the same one
  const std::size_t count = minibatches(), most = settings_.epochs * count;
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
  average();
  see();
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
  pace.go_to(progressed.iteration, progressed.course);
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
