#include "targets/environments/train/sac/sac.hpp"

#include <fmt/format.h>

#include <eagerx/math.hpp>
#include <numeric>

#include "targets/environments/train/checkpoint.hpp"
#include "targets/environments/train/sac/log.hpp"

namespace eagerx::train::sac {
namespace {

/// The description, if its actions are real numbers.
const Library& real_numbers(const Library& library) {
  if (!library.description().chooses()) return library;
  throw Problem(kProblems, "SAC learns real numbers, and the graph's actions are whole ones",
                "train it with `--algorithm ppo`, or give them float spaces");
}

}  // namespace

Sac::Sac(const train::Settings& settings, const Library& library, const Kernels& kernels,
         ThreadPool& pool, std::uint32_t longest)
    : Algorithm(pace_of(settings, library.description())),
      settings_(settings),
      description_(library.description()),
      model_(settings_, library.description().observation_numbers(),
             Head(real_numbers(library).description()), library.description().critic_numbers()),
      critic_(critic_of(library.description())),
      deployed_(sac::deployed(settings_, model_)),
      kernels_(kernels),
      pool_(pool),
      collector_(settings_, library, longest) {
  const std::size_t tiles = settings.sac.batch_size / (kParts * kLanes);
  for (std::size_t part = 0; part < kParts; ++part)
    learners_.push_back(std::make_unique<Learner>(model_, tiles));
}

void Sac::set_stage(const std::string& name) {
  collector_.set_stage(name);
}

void Sac::begin_era() {
  collector_.reset(settings_.seed + (std::uint64_t{pace.era} << 32U));
  if (model_.observations.count == 0.0 && settings_.norm_obs)
    model_.observations.add(collector_.observation_sums);
}

void Sac::go_on() {
  begin_era();
  const std::size_t transitions = pace.since_era * environments();
  if (transitions > model_.memory.size()) return;
  for (std::size_t back = transitions; back > 0; back -= environments())
    collector_.step_again(model_.memory, back - 1);
}

Algorithm::Result Sac::iterate() {
  collector_.episodes.clear();
  collector_.observation_sums.clear();
  collector_.return_sums.clear();
  collector_.reward_sums.clear();
  const Normaliser normaliser(model_.observations);
  const std::uint64_t updates = model_.actor_adam.steps;
  for (std::size_t t = 0; t < settings_.sac.train_freq; ++t) {
    const bool is_random =
        !model_.was_taught && model_.memory.added < settings_.sac.learning_starts;
    collector_.step(model_, normaliser, kernels_, is_random,
                    static_cast<std::uint32_t>(pace.time + t));
    while (model_.actor_adam.steps < model_.due()) update(normaliser);
  }
  see();
  done_.steps += settings_.sac.train_freq * settings_.sac.n_envs;
  pace.next();
  return {collector_.episodes, 0.0, model_.actor_adam.steps - updates};
}

/// Converts the networks from the previous scales to the new ones. Rewards have
/// another scale, and so have the critics' answers and the weight of the entropy.
void Sac::see() {
  const double scale = model_.reward_scale;
  const Statistics before = model_.observations;
  if (settings_.sac.norm_window_steps > 0.0) {
    model_.returns.forget_beyond(settings_.sac.norm_window_steps);
    model_.rewards.forget_beyond(settings_.sac.norm_window_steps);
    model_.observations.forget_beyond(settings_.sac.norm_window_steps);
  }
  model_.returns.add(collector_.return_sums);
  model_.rewards.add(collector_.reward_sums);
  if (settings_.norm_obs) model_.observations.add(collector_.observation_sums);
  if (scale == 0.0) return;
  model_.reward_scale = model_.estimated_scale();
  const auto ratio = static_cast<float>(model_.reward_scale / scale);
  const Network::Layer& last = model_.critic.layers().back();
  for (Critic& critic : model_.critics) {
    for (auto* parameters : {&critic.parameters, &critic.target}) {
      for (std::size_t i = last.weights; i < last.bias + last.sizes.outputs; ++i)
        (*parameters)[i] *= ratio;
      keep_answers(model_.critic, *parameters, before, model_.observations);
    }
  }
  for (auto* parameters : {&model_.actor_parameters, &model_.averaged})
    keep_answers(model_.actor, *parameters, before, model_.observations);
  model_.log_temperature.front() += log(ratio);
}

/// At first the mean of all so far: the first actor knows nothing and is forgotten soon.
void Sac::average() {
  const float share =
      max(settings_.sac.ema_rate, 2.0F / (static_cast<float>(model_.actor_adam.steps) + 1.0F));
  kernels_.approach(min(share, 1.0F), model_.actor_parameters.data(), model_.averaged.data(),
                    model_.averaged.size());
}

void Sac::update(const Normaliser& normaliser) {
  const auto number = static_cast<std::uint32_t>(model_.actor_adam.steps);
  if (model_.reward_scale == 0.0) model_.reward_scale = model_.estimated_scale();
  const Frozen frozen{kernels_,
                      settings_,
                      model_,
                      normaliser,
                      static_cast<float>(model_.reward_scale),
                      exp(model_.log_temperature.front())};
  const bool is_alone = pool_.size() == 1;  // one clock for all parts, because each costs 1 %
  Stopwatch watch;
  pool_.run_parts(kParts, [&](std::size_t part) {
    const Random random({settings_.seed, static_cast<std::uint32_t>(part), number},
                        entity_id("train/batch"));
    if (is_alone) return learners_[part]->learn(frozen, random);
    const Stopwatch own;
    learners_[part]->learn(frozen, random);
    learning_s_[part] += own.seconds();
  });
  if (!is_alone) watch = Stopwatch();
  done_.samples += settings_.sac.batch_size;
  Gradient& sum = learners_.front()->gradient;
  for (std::size_t part = 1; part < kParts; ++part) sum.add(kernels_, learners_[part]->gradient);
  const auto count = static_cast<double>(settings_.sac.batch_size);
  const auto scale = static_cast<float>(1.0 / count);
  const float step_size = settings_.learning_rate * settings_.decay(steps());
  model_.actor_adam.step(kernels_, model_.actor_parameters, sum.actor, step_size, scale);
  average();
  for (std::size_t c = 0; c < 2; ++c) {
    Critic& critic = model_.critics[c];
    critic.adam.step(kernels_, critic.parameters, sum.critics[c], step_size, scale);
    kernels_.approach(settings_.sac.tau, critic.parameters.data(), critic.target.data(),
                      critic.target.size());
  }
  const auto numbers = static_cast<double>(deployed_.outputs());
  const double surplus =
      -sum.log_probability / count - numbers * settings_.sac.target_entropy_per_action;
  model_.temperature_adam.step(kernels_, model_.log_temperature, {static_cast<float>(surplus)},
                               step_size, 1.0F);
  deviation_ = sum.deviation / count;
  updating_s_ += watch.seconds();
}

Spent Sac::spent() const {
  Spent spent = collector_.spent;
  spent.learning_s += updating_s_ + std::accumulate(learning_s_.begin(), learning_s_.end(), 0.0);
  return spent;
}

std::vector<float> Sac::deployed_parameters() const {
  return sac::deployed_parameters(deployed_, model_);
}

std::string Sac::checkpoint(const std::string& conditions, const std::string& interface,
                            Progressed& progressed) const {
  return checkpoint_of(conditions + critic_, interface + critic_, model_, progressed);
}

void Sac::restore(const std::string& bytes, const std::string& name, const std::string& conditions,
                  Progressed& progressed) {
  train::restore(bytes, name, conditions + critic_, model_, progressed);
  pace.go_to(progressed.iteration, progressed.curriculum);
}

void Sac::begin_from(const std::string& bytes, const std::string& name,
                     const std::string& interface) {
  train::begin_from(bytes, name, interface + critic_, model_);
}

std::string Sac::replay(const std::string& text, const std::string& name) {
  if (!critic_.empty()) {
    throw Problem(
        kUsage, fmt::format("`{}` does not say what the critic sees: `critic:` of the task", name),
        "leave out `critic:`, or `--replay`");
  }
  Sums observations(model_.actor.inputs()), returns(1), rewards(2);
  const Log log = read_log(text, name, description_, settings_.gamma, model_.memory, observations,
                           returns, rewards);
  if (log.transitions == 0)
    throw Problem(kInputOutput, fmt::format("`{}` has no step that can be learnt from", name));
  if (settings_.norm_obs) model_.observations.add(observations);
  model_.returns.add(returns);
  model_.rewards.add(rewards);
  model_.replayed += log.transitions;
  model_.was_taught = true;
  std::string said = fmt::format("{} steps of {}", log.transitions, name);
  if (log.left_out > 0) said += fmt::format(", without {} that lack numbers", log.left_out);
  return said;
}

}  // namespace eagerx::train::sac
