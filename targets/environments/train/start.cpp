#include "targets/environments/train/start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "targets/environments/train/checkpoint.hpp"
#include "targets/environments/train/export.hpp"
#include "targets/environments/train/ppo.hpp"
#include "targets/environments/train/sac/sac.hpp"
#include "targets/environments/train/seeds.hpp"
#include "targets/environments/train/tensorboard.hpp"

namespace eagerx::train {
namespace {

bool is_sac(const Settings& settings) {
  return settings.algorithm == "sac";
}

/// Each value of a whole number is an output of the network.
void check_choices(const Description& description) {
  constexpr double kMost = 1000.0;
  double outputs = 0.0;
  for (const Space& action : description.actions) {
    for (std::size_t i = 0; i < action.size; ++i) {
      const double values = action.high[i] - action.low[i] + 1.0;
      outputs += values;
      if (values <= kMost) continue;
      throw Problem(kProblems,
                    fmt::format("the action `{}` has more than 1000 choices", action.name),
                    "give its space `low` and `high` nearer to each other, or a float dtype");
    }
  }
  if (outputs <= kMost) return;
  throw Problem(
      kProblems,
      fmt::format("the actions have {} choices together, and a network can have 1000", outputs),
      "give their spaces `low` and `high` nearer to each other, or a float dtype");
}

/// Refuses actions that are neither all whole nor all real numbers.
void check_real(const Description& description, const Space& action) {
  if (action.dtype.starts_with("float")) return;
  const auto real = std::ranges::find_if(
      description.actions, [](const Space& other) { return other.dtype.starts_with("float"); });
  if (action.is_whole() && real != description.actions.end())
    throw Problem(kProblems,
                  fmt::format("the action `{}` is {}, and `{}` is {}: actions are whole numbers, "
                              "or real ones, not both",
                              action.name, action.dtype, real->name, real->dtype),
                  "give all of them a float space, or all an integer one with `low` and `high`");
  throw Problem(kProblems,
                fmt::format("the action `{}` is {}: real numbers can be trained, or whole ones",
                            action.name, action.dtype),
                "give it a float space, or an integer one with `low: 0` and `high: 1`");
}

void check_trainable(const Description& description) {
  if (!description.has_task) {
    throw Problem(kProblems, "the graph says no reward: it has no `task:`",
                  "write one:\n"
                  "  task:\n"
                  "    inputs: {angle: pendulum.theta}\n"
                  "    reward: {upright: {value: angle^2, weight: -1.0}}\n"
                  "    truncated: {after: 5.0}\n"
                  "    success: {upright: abs(angle) < 0.15, over_last: 2.0}");
  }
  if (description.observations.empty()) throw Problem(kProblems, "the graph has no observations");
  if (description.actions.empty()) throw Problem(kProblems, "the graph has no actions");
  if (description.chooses()) return check_choices(description);
  for (const Space& action : description.actions) {
    check_real(description, action);
    for (std::size_t i = 0; i < action.size; ++i) {
      if (std::isfinite(action.low[i]) && std::isfinite(action.high[i])) continue;
      throw Problem(kProblems, fmt::format("the action `{}` has no bounds", action.name),
                    "give its space `low` and `high`");
    }
  }
}

}  // namespace

void check_files(const Options& options) {
  claim_output(options.output);
  claim_output(golden_path(options.output));
  for (const std::string* path : {&options.csv, &options.curve, &options.record}) {
    if (!path->empty()) claim_output(*path);
  }
  if (options.seeds > 1) {
    check_files_of_seeds(options);
  } else {
    if (!options.checkpoint.empty()) claim_output(options.checkpoint);
    if (!options.resume.empty())
      check_resumed(read_file(options.resume), options.resume, options.settings);
  }
  if (!options.tensorboard.empty()) check_folder(options.tensorboard);
  if (!options.from.empty())
    check_begun_from(read_file(options.from), options.from, options.settings);
  if (!options.failure_replay.empty()) read_file(options.failure_replay);
  for (const std::string& path : options.replay) read_file(path);
}

const Description& checked(const Library& library) {
  check_trainable(library.description());
  return library.description();
}

const Kernels& chosen_kernels(const std::string& name) {
  const Kernels* kernels = find_kernels(name);
  if (kernels != nullptr) return *kernels;
  throw Problem(kUsage, "this machine has no kernels `" + name + "`");
}

unsigned chosen_threads(unsigned threads) {
  return threads > 0 ? threads : host::usable_cores();
}

std::unique_ptr<Algorithm> chosen_algorithm(Settings settings, const Library& library,
                                            const Kernels& kernels, ThreadPool& pool,
                                            Ranks& ranks) {
  const std::uint32_t longest = longest_of(library.description());
  if (!is_sac(settings))
    return std::make_unique<Ppo>(settings, library, kernels, pool, longest, ranks);
  // A continued training takes the actions of its era from the memory.
  sac::Settings& s = settings.sac;
  const std::size_t era = pace_of(settings, library.description()).era_steps + s.train_freq - 1;
  s.buffer_size = std::max(s.buffer_size, era / s.train_freq * s.train_freq * s.n_envs);
  return std::make_unique<sac::Sac>(settings, library, kernels, pool, longest);
}

}  // namespace eagerx::train
