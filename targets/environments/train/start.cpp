#include "targets/environments/train/start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

/// Each choice is an output of the network.
void check_choices(const Space& action) {
  constexpr double kMost = 1000.0;
  if (action.high.front() - action.low.front() < kMost) return;
  throw Problem(kProblems, fmt::format("the action `{}` has more than 1000 choices", action.name),
                "give its space `low` and `high` nearer to each other, or a float dtype");
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
  if (description.chooses()) return check_choices(description.actions.front());
  for (const Space& action : description.actions) {
    if (!action.dtype.starts_with("float")) {
      throw Problem(kProblems,
                    fmt::format("the action `{}` is {}: only real numbers can be trained, or one "
                                "whole number as the only action",
                                action.name, action.dtype),
                    "give it a float space, or let one number choose among all combinations");
    }
    for (std::size_t i = 0; i < action.size; ++i) {
      if (std::isfinite(action.low[i]) && std::isfinite(action.high[i])) continue;
      throw Problem(kProblems, fmt::format("the action `{}` has no bounds", action.name),
                    "give its space `low` and `high`");
    }
  }
}

}  // namespace

void check_files(const Options& options) {
  check_writable(options.output);
  check_writable(golden_path(options.output));
  for (const std::string* path : {&options.csv, &options.curve}) {
    if (!path->empty()) check_writable(*path);
  }
  if (options.seeds > 1) {
    check_files_of_seeds(options);
  } else {
    if (!options.checkpoint.empty()) check_writable(options.checkpoint);
    if (!options.resume.empty()) read_file(options.resume);
  }
  if (!options.tensorboard.empty()) check_folder(options.tensorboard);
  for (const std::string* path : {&options.from, &options.hard_starts}) {
    if (!path->empty()) read_file(*path);
  }
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
                                            const Kernels& kernels, Team& team, Ranks& ranks) {
  const std::uint32_t longest = longest_of(library.description());
  if (!is_sac(settings))
    return std::make_unique<Ppo>(settings, library, kernels, team, longest, ranks);
  // A training that goes on takes the actions of its era from the memory.
  sac::Settings& s = settings.sac;
  const std::size_t era = pace_of(settings, library.description()).era_steps + s.horizon - 1;
  s.memory = std::max(s.memory, era / s.horizon * s.horizon * s.environments);
  return std::make_unique<sac::Sac>(settings, library, kernels, team, longest);
}

}  // namespace eagerx::train
