#include "targets/environments/train/training.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <eagerx/math.hpp>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

#include "targets/environments/train/client.hpp"
#include "targets/environments/train/export.hpp"
#include "targets/environments/train/ppo.hpp"
#include "targets/environments/train/sac/sac.hpp"

namespace eagerx::train {
namespace {

constexpr std::uint32_t kLongest = 1000;   // steps of an episode that nothing ends
constexpr std::uint64_t kEvaluations = 4;  // of a policy that seems to be the best
constexpr std::uint64_t kEvaluationSeed = std::uint64_t{1} << 63U;
constexpr std::uint64_t kLastSeed = kEvaluationSeed + (std::uint64_t{1} << 62U);
constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

const Kernels& chosen_kernels(const std::string& name) {
  const Kernels* kernels = find_kernels(name);
  if (kernels != nullptr) return *kernels;
  throw Problem(kUsage, "this machine has no kernels `" + name + "`");
}

unsigned chosen_threads(unsigned threads) {
  return threads > 0 ? threads : host::usable_cores();
}

bool is_sac(const Settings& settings) {
  return settings.algorithm == "sac";
}

/// Long enough for some episodes: PPO cuts the first ones, and SAC has few environments.
std::uint32_t era_of(const Settings& settings, const Description& description) {
  constexpr std::uint32_t kLeast = 1024;  // steps
  const std::uint32_t episodes = is_sac(settings) ? 2 : 5;
  const auto steps =
      episodes * (description.episode_steps > 0 ? description.episode_steps : kLongest);
  const auto horizon =
      static_cast<std::uint32_t>(is_sac(settings) ? settings.sac.horizon : settings.horizon);
  return (std::max(kLeast, steps) + horizon - 1) / horizon;
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

/// The description, if one can train on it.
const Description& checked(const Library& library) {
  check_trainable(library.description());
  return library.description();
}

/// `era`: iterations between two starts of all environments.
std::unique_ptr<Algorithm> chosen_algorithm(Settings settings, const Library& library,
                                            const Kernels& kernels, Team& team,
                                            std::uint32_t longest, std::uint32_t era) {
  if (!is_sac(settings)) return std::make_unique<Ppo>(settings, library, kernels, team, longest);
  // A training that goes on takes the actions of its era from the memory.
  sac::Settings& s = settings.sac;
  s.memory = std::max(s.memory, era * s.horizon * s.environments);
  return std::make_unique<sac::Sac>(settings, library, kernels, team, longest);
}

}  // namespace

void check_files(const Options& options) {
  check_writable(options.output);
  check_writable(golden_path(options.output));
  for (const std::string* path : {&options.checkpoint, &options.csv, &options.curve}) {
    if (!path->empty()) check_writable(*path);
  }
  if (!options.tensorboard.empty()) check_folder(options.tensorboard);
  for (const std::string* path : {&options.resume, &options.from}) {
    if (!path->empty()) read_file(*path);
  }
  for (const std::string& path : options.replay) read_file(path);
}

Training::Training(const Options& options, const Library& library, Table table)
    : options_(options),
      library_(library),
      kernels_(chosen_kernels(options.kernels)),
      longest_(checked(library).episode_steps > 0 ? 0 : kLongest),
      era_(era_of(options.settings, library.description())),
      has_aim_(library.description().has_success || std::isfinite(options.settings.until_return)),
      conditions_(conditions(options.settings, library.description().hash)),
      interface_(interface_of(options.settings, library.description())),
      head_(library.description()),
      team_(chosen_threads(options.threads), Team::Size::at_most),
      algorithm_(chosen_algorithm(options.settings, library, kernels_, team_, longest_, era_)),
      evaluator_(library, kernels_, team_, longest_, options.settings.evaluation_episodes),
      table_(std::move(table)),
      curve_file_(options.csv),
      progress_(0, 0, false, true) {
  if (!options.resume.empty()) {
    algorithm_->restore(read_file(options.resume), options.resume, conditions_, progressed_, era_);
    first_iteration_ = algorithm_->iteration;
    goes_on_ = true;
  }
  if (!options.from.empty())
    algorithm_->begin_from(read_file(options.from), options.from, interface_);
  for (const std::string& log : options.replay) {
    const std::string said = algorithm_->replay(read_file(log), log);
    if (!options.is_quiet) fmt::print(stderr, "{}\n", said);
  }
  if (!options.checkpoint.empty()) algorithm_->remember_actions();
  progress_ = Progress(steps(), options.steps, library.description().has_success, options.is_quiet);
}

std::uint64_t Training::steps() const {
  return std::uint64_t{algorithm_->iteration} * algorithm_->steps();
}

int Training::run(const Interrupt& is_interrupted) {
  if (!options_.is_quiet) {
    fmt::print(stderr, "{} environments step {}\n", algorithm_->environments(),
               algorithm_->stepping());
  }
  open_events();
  const Ending ending = learn(is_interrupted);
  progress_.finish();
  const std::optional<Problem> unsaved = save();  // before what may take long, or fail
  if (progressed_.best.parameters.empty()) {
    CurvePoint unused{};
    evaluate(unused);
  }
  last_ = evaluate_at_last();
  write_policy();
  write_curve();
  if (!options_.is_quiet) print(report(last_, ending));
  if (unsaved) throw *unsaved;
  if (ending == Ending::interrupted) return 130;  // as shells say it
  return ending == Ending::success || !has_aim_ ? kDone : kProblems;
}

/// With what a problem of the graph is hard to find without.
void Training::tell_where(const Problem& problem) {
  progress_.finish();
  std::string saved;
  if (algorithm_->iteration > first_iteration_ && !options_.checkpoint.empty()) {
    const std::optional<Problem> unsaved = save();
    saved = unsaved ? fmt::format("\nnote: {}", unsaved->what())
                    : fmt::format("; what it had learnt is in `{}`", options_.checkpoint);
  }
  if (problem.code != kProblems) throw problem;
  throw Problem(problem.code,
                fmt::format("{}\nnote: the training had made {} steps with `--seed {}`{}",
                            problem.what(), steps(), options_.settings.seed, saved),
                problem.help);
}

Ending Training::learn(const Interrupt& is_interrupted) {
  try {
    return iterate(is_interrupted);
  } catch (const Problem& problem) {
    tell_where(problem);
  }
}

/// Whenever it returns or throws, a checkpoint can be written, and resumed with the next iteration
/// or the evaluation that is due.
Ending Training::iterate(const Interrupt& is_interrupted) {
  while (!progressed_.succeeded) {
    if (is_evaluation_due() && evaluate(progressed_.curve.back())) {
      progressed_.succeeded = true;
      show();
      break;
    }
    if (algorithm_->iteration > first_iteration_) show();
    if (steps() >= options_.steps) return Ending::steps;
    if (is_interrupted) return Ending::interrupted;
    start_iteration();
    progressed_.curve.push_back(note(algorithm_->iterate()));
  }
  return Ending::success;
}

/// A file of events has the points that a resumed training begins with, too.
void Training::open_events() {
  if (options_.tensorboard.empty()) return;
  events_.emplace(options_.tensorboard, library_.description().graph);
  for (const CurvePoint& point : progressed_.curve) events_->append(point);
}

void Training::show() {
  const CurvePoint& point = progressed_.curve.back();
  progress_.show(point);
  grow_curve();
  if (!events_) return;
  Scalars terms;
  const std::vector<std::string>& names = library_.description().terms;
  for (std::size_t i = 0; !std::isnan(point.evaluation_return) && i < seen_.terms.size(); ++i)
    terms.emplace_back("terms/" + names[i], seen_.terms[i]);
  const bool was_written = events_->problem().empty();
  events_->append(point, terms);
  if (!was_written || events_->problem().empty()) return;
  progress_.finish();
  fmt::print(stderr, "warning: {}; the training goes on without it\n", events_->problem());
}

/// A disk that is full now may have room in a second; at the end it is an error.
void Training::grow_curve() {
  const std::string problem =
      curve_file_.grow(progress_.seconds(), [this] { return table_(progressed_.curve); });
  if (problem.empty()) return;
  progress_.finish();
  fmt::print(stderr, "warning: {}; the training goes on and tries again\n", problem);
}

bool Training::is_evaluation_due() const {
  return algorithm_->iteration > 0 &&
         algorithm_->iteration % options_.settings.evaluation_every == 0 &&
         std::isnan(progressed_.curve.back().evaluation_return);
}

void Training::start_iteration() {
  const bool begins_era = algorithm_->iteration % era_ == 0;
  if (algorithm_->iteration > first_iteration_) save_if_due(begins_era);
  if (begins_era) {
    algorithm_->begin_era(algorithm_->iteration / era_);
  } else if (goes_on_) {
    algorithm_->go_on(algorithm_->iteration / era_);
  }
  goes_on_ = false;
}

void Training::write_checkpoint() {
  progressed_.iteration = algorithm_->iteration;
  write_file(options_.checkpoint, algorithm_->checkpoint(conditions_, interface_, progressed_,
                                                         algorithm_->iteration % era_));
}

/// Why it could not be written, if so.
std::optional<Problem> Training::save() {
  std::optional<Problem> problem;
  if (options_.checkpoint.empty()) return problem;
  try {
    write_checkpoint();
  } catch (const Problem& what) {
    problem = what;
  }
  is_saved_ = !problem;
  tried_ = Clock::now();
  return problem;
}

/// A disk that is full now may have room in a minute.
void Training::save_if_due(bool begins_era) {
  const std::chrono::duration<double> since = Clock::now() - tried_;
  if (!begins_era && since.count() < options_.checkpoint_every_s) return;
  const bool was_saved = is_saved_;
  const std::optional<Problem> problem = save();
  if (!problem || !was_saved) return;
  progress_.finish();
  fmt::print(stderr, "warning: {}; the training goes on and tries again\n", problem->what());
}

CurvePoint Training::note(const Algorithm::Result& result) {
  std::vector<Episode>& recent = progressed_.recent;
  recent.insert(recent.end(), result.episodes.begin(), result.episodes.end());
  if (recent.size() > kRecent)
    recent.erase(recent.begin(), recent.end() - static_cast<std::ptrdiff_t>(kRecent));
  double returns = 0.0, successes = 0.0;
  for (const Episode& episode : recent) {
    returns += episode.sum;
    successes += episode.success;
  }
  const auto count = static_cast<double>(recent.size());
  const bool has_success = library_.description().has_success;
  return {static_cast<double>(steps()),
          count > 0 ? returns / count : kNothing,
          count > 0 && has_success ? successes / count : kNothing,
          kNothing,
          kNothing,
          algorithm_->deviation(),
          algorithm_->step_size(),
          result.divergence};
}

bool Training::is_good(const Evaluation& evaluation) const {
  if (!has_aim_ || evaluation.mean_return < options_.settings.until_return) return false;
  return !library_.description().has_success || evaluation.passed();
}

/// The best policy, in as many episodes as have chosen it, which are all others.
Evaluation Training::evaluate_at_last() {
  const Policy best = policy(progressed_.best.parameters);
  Evaluation evaluation = run(best, kLastSeed);
  for (std::uint64_t more = 1; more < kEvaluations; ++more)
    evaluation.add(run(best, kLastSeed + more));
  return evaluation;
}

Evaluation Training::run(const Policy& policy, std::uint64_t seed) {
  return evaluator_.run(policy, seed, algorithm_->observations());
}

/// All the episodes that choose the best policy: those that it was seen in and three times as many.
Evaluation Training::judge(const Policy& now, Evaluation seen) {
  for (std::uint64_t more = 1; more < kEvaluations; ++more)
    seen.add(run(now, kEvaluationSeed + more));
  return seen;
}

/// One of many evaluations may be good by luck: as many episodes that have chosen nothing.
bool Training::is_confirmed(const Policy& now) {
  const std::uint64_t seed =
      kEvaluationSeed + kEvaluations * (std::uint64_t{algorithm_->iteration} + 1);
  for (std::uint64_t more = 0; more < kEvaluations; ++more) {
    if (!is_good(run(now, seed + more))) return false;
  }
  return true;
}

/// Whether the policy is good.
bool Training::evaluate(CurvePoint& point) {
  Policy now = policy(algorithm_->deployed_parameters());
  const Evaluation evaluation = run(now, kEvaluationSeed);
  Best& best = progressed_.best;
  const Score seen{evaluation.successes, evaluation.mean_return};
  bool succeeds = false;
  if (best.parameters.empty() || seen.is_better_than(best.seen) || is_good(evaluation)) {
    const Evaluation all = judge(now, evaluation);
    const Score judged{all.successes, all.mean_return};
    succeeds = is_good(all) && is_confirmed(now);
    if (best.parameters.empty() || judged.is_better_than(best.judged) || succeeds)
      best = {std::move(now.parameters), seen, judged};
  }
  seen_ = evaluation;
  // All at once, for who goes on after an exception.
  point.evaluation_return = evaluation.mean_return;
  if (library_.description().has_success) {
    point.evaluation_success =
        static_cast<double>(evaluation.successes) / static_cast<double>(evaluation.episodes);
  }
  return succeeds;
}

Policy Training::policy(std::vector<float> parameters) const {
  return {algorithm_->deployed(), std::move(parameters), head_};
}

std::string Training::report(const Evaluation& evaluation, Ending ending) const {
  return summary({.options = options_,
                  .description = library_.description(),
                  .curve = progressed_.curve,
                  .kernels = kernels_.name,
                  .steps = steps(),
                  .seconds = progress_.seconds(),
                  .ending = ending,
                  .has_aim = has_aim_},
                 evaluation);
}

void Training::write_policy() const {
  const Policy best = policy(progressed_.best.parameters);
  const std::size_t width = best.network.inputs();
  // Observations as they are in an episode: around the mean that was seen, by their deviation.
  constexpr std::size_t kRows = 256;
  Random random({options_.settings.seed, 0, 0}, entity_id("train/golden"));
  std::vector<float> rows;
  for (std::size_t i = 0; i < kRows * width; ++i) {
    const Statistics& seen = algorithm_->observations();
    rows.push_back(random.normal(static_cast<float>(seen.mean[i % width]),
                                 static_cast<float>(1.0 / seen.scale(i % width))));
  }
  write_files({{options_.output, safetensors_of(best, library_.description(), options_.settings)},
               {golden_path(options_.output), golden_rows(best, kernels_, rows)}});
}

void Training::write_curve() const {
  const std::string& name = library_.description().graph;
  if (!options_.csv.empty()) write_file(options_.csv, table_(progressed_.curve));
  if (!options_.curve.empty()) write_file(options_.curve, curve_svg(progressed_.curve, name));
}

}  // namespace eagerx::train
