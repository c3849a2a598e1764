#include "targets/environments/train/training.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include "targets/environments/train/client.hpp"
#include "targets/environments/train/export.hpp"

namespace eagerx::train {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

}  // namespace

Training::Training(const Options& options, const Library& library, Table table, Ranks& ranks)
    : options_(options),
      library_(library),
      kernels_(chosen_kernels(options.kernels)),
      ranks_(ranks),
      era_(era_of(options.settings, checked(library))),
      conditions_(conditions(options.settings, library.description().hash)),
      interface_(interface_of(options.settings, library.description())),
      team_(chosen_threads(options.threads), Team::Size::at_most),
      algorithm_(chosen_algorithm(options.settings, library, kernels_, team_, ranks)),
      judge_(options.settings, library, kernels_, team_, ranks),
      saving_(ranks.is_first() ? options.checkpoint : std::string(), options.checkpoint_every_s,
              [this] { return checkpoint(); }),
      showing_(options, library.description(), begin(), std::move(table)) {}

/// With a checkpoint, what another training has learnt, or logs. Returns the first step.
std::uint64_t Training::begin() {
  if (!options_.resume.empty()) {
    algorithm_->restore(read_file(options_.resume), options_.resume, conditions_, progressed_,
                        era_);
    first_iteration_ = algorithm_->iteration;
    goes_on_ = true;
  }
  if (!options_.from.empty())
    algorithm_->begin_from(read_file(options_.from), options_.from, interface_);
  for (const std::string& log : options_.replay) {
    const std::string said = algorithm_->replay(read_file(log), log);
    if (!options_.is_quiet) fmt::print(stderr, "{}\n", said);
  }
  if (!options_.checkpoint.empty()) algorithm_->remember_actions();
  return steps();
}

std::uint64_t Training::steps() const {
  return std::uint64_t{algorithm_->iteration} * algorithm_->steps();
}

int Training::run(const Interrupt& is_interrupted) {
  if (!options_.is_quiet) {
    fmt::print(stderr, "{} environments step {}\n", algorithm_->environments(),
               algorithm_->stepping());
  }
  showing_.open_events(progressed_.curve);
  const Ending ending = learn(is_interrupted);
  showing_.finish();
  const std::optional<Problem> unsaved = saving_.save();  // before what may take long, or fail
  if (progressed_.best.parameters.empty()) {
    CurvePoint unused{};
    evaluate(unused);
  }
  last_ = judge_.evaluate_at_last(*algorithm_, progressed_.best);
  if (ranks_.is_first()) {
    write_policy();
    write_curve();
  }
  if (!options_.is_quiet) print(report(last_, ending));
  if (unsaved) throw *unsaved;
  if (ending == Ending::interrupted) return kInterrupted;
  return ending == Ending::success || !judge_.has_aim() ? kDone : kProblems;
}

/// With what a problem of the graph is hard to find without.
void Training::tell_where(const Problem& problem) {
  showing_.finish();
  std::string saved;
  if (algorithm_->iteration > first_iteration_ && saving_.is_wanted()) {
    const std::optional<Problem> unsaved = saving_.save();
    saved = unsaved ? fmt::format("\nnote: {}", unsaved->what())
                    : fmt::format("; what it had learnt is in `{}`", options_.checkpoint);
  }
  if (problem.code != kProblems && problem.code != kInterrupted) throw problem;
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
      showing_.show(progressed_.curve, judge_.seen());
      break;
    }
    if (algorithm_->iteration > first_iteration_) showing_.show(progressed_.curve, judge_.seen());
    if (steps() >= options_.steps) return Ending::steps;
    if (ranks_.is_any(is_interrupted)) return Ending::interrupted;
    start_iteration();
    progressed_.curve.push_back(note(algorithm_->iterate()));
  }
  return Ending::success;
}

bool Training::is_evaluation_due() const {
  return algorithm_->iteration > 0 &&
         algorithm_->iteration % options_.settings.evaluation_every == 0 &&
         std::isnan(progressed_.curve.back().evaluation_return);
}

bool Training::evaluate(CurvePoint& point) {
  return judge_.evaluate(*algorithm_, progressed_.best, point);
}

void Training::start_iteration() {
  const bool begins_era = algorithm_->iteration % era_ == 0;
  if (algorithm_->iteration > first_iteration_) {
    const std::optional<Problem> problem = saving_.save_if_due(begins_era);
    if (problem) showing_.warn(problem->what(), "and tries again");
  }
  if (begins_era) {
    algorithm_->begin_era(algorithm_->iteration / era_);
  } else if (goes_on_) {
    algorithm_->go_on(algorithm_->iteration / era_);
  }
  goes_on_ = false;
}

std::string Training::checkpoint() {
  progressed_.iteration = algorithm_->iteration;
  return algorithm_->checkpoint(conditions_, interface_, progressed_, algorithm_->iteration % era_);
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

std::string Training::report(const Evaluation& evaluation, Ending ending) const {
  return summary({.options = options_,
                  .description = library_.description(),
                  .curve = progressed_.curve,
                  .kernels = kernels_.name,
                  .steps = steps(),
                  .seconds = showing_.seconds(),
                  .ending = ending,
                  .has_aim = judge_.has_aim()},
                 evaluation);
}

void Training::write_policy() const {
  const Policy best = judge_.policy(*algorithm_, progressed_.best.parameters);
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
  if (!options_.csv.empty()) write_file(options_.csv, showing_.table(progressed_.curve));
  if (!options_.curve.empty()) write_file(options_.curve, curve_svg(progressed_.curve, name));
}

}  // namespace eagerx::train
