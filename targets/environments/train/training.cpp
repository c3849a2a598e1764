#include "targets/environments/train/training.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <runtime/host/base/hash.hpp>
#include <utility>

#include "targets/environments/train/client.hpp"
#include "targets/environments/train/export.hpp"
#include "targets/environments/train/failure_replay.hpp"

namespace eagerx::train {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

Settings settings_of(const Options& options, const Description& description) {
  Settings settings = options.settings;
  if (!options.failure_replay.empty())
    settings.failure_replay = std::make_shared<const FailureReplay>(
        read_file(options.failure_replay), options.failure_replay, description);
  return settings;
}

/// All that the bits of a training depend on.
std::string conditions_of(const Options& options, const Description& description) {
  std::string text = conditions(options.settings, description.hash);
  if (!options.failure_replay.empty())
    text += fmt::format("; failure-replay {:016x}", host::fnv1a(read_file(options.failure_replay)));
  return text;
}

}  // namespace

Training::Training(const Options& options, const Library& library,
                   ProgressReport::SharedTable table, Ranks& ranks)
    : options_(options),
      library_(library),
      kernels_(chosen_kernels(options.kernels)),
      ranks_(ranks),
      settings_(settings_of(options, checked(library))),
      conditions_(conditions_of(options, library.description())),
      interface_(interface_of(options.settings, library.description())),
      pool_(chosen_threads(options.threads), ThreadPool::Size::at_most),
      algorithm_(chosen_algorithm(settings_, library, kernels_, pool_, ranks)),
      selection_(options.settings, library, kernels_, pool_, ranks),
      saving_(ranks.is_first() ? options.checkpoint : std::string(), options.checkpoint_every_s,
              [this] { return checkpoint(); }),
      report_(options, library.description(), begin(), std::move(table)) {}

/// With a checkpoint, what another training has learnt, or logs. Returns the first step.
std::uint64_t Training::begin() {
  if (!options_.resume.empty()) {
    algorithm_->restore(read_file(options_.resume), options_.resume, conditions_, progressed_);
    first_iteration_ = algorithm_->pace.iteration;
    continues_ = true;
  }
  set_stage();
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
  return algorithm_->steps();
}

int Training::run(const Stop& stop) {
  if (!options_.is_quiet) {
    const std::size_t parts = algorithm_->parts();
    fmt::print(stderr, "{}{}{} environments{} step {}\n", options_.name,
               options_.name.empty() ? "" : ": ", algorithm_->environments(),
               parts == 1 ? "" : fmt::format(" in {} parts", parts), algorithm_->stepping());
  }
  report_.open_events(progressed_.curve);
  const Ending ending = learn(stop);
  report_.finish();
  const std::optional<Problem> unsaved = saving_.save();  // before what may take long, or fail
  evaluate_at_last();
  if (ranks_.is_first()) {
    if (!options_.output.empty()) write_policy(options_.output);
    write_curves();
    if (!options_.output.empty()) report_.record().end(ended(ending), last_);
  }
  if (!options_.is_quiet)
    print((options_.name.empty() ? "" : options_.name + "\n") + summary(ended(ending), last_));
  if (unsaved) throw *unsaved;
  if (ending == Ending::interrupted) return kInterrupted;
  return ending == Ending::success || !selection_.has_aim() ? kDone : kProblems;
}

/// With what a problem of the graph is hard to find without.
void Training::tell_where(const Problem& problem) {
  report_.finish();
  std::string saved;
  if (algorithm_->pace.iteration > first_iteration_ && saving_.is_wanted()) {
    const std::optional<Problem> unsaved = saving_.save();
    saved = unsaved ? fmt::format("\nnote: {}", unsaved->what())
                    : fmt::format("; what it had learnt is in `{}`", options_.checkpoint);
  }
  if (ranks_.is_first()) report_.record().fail(options_.settings.seed, progressed_.curve, problem);
  if (problem.code != kProblems && problem.code != kInterrupted) throw problem;
  throw Problem(problem.code,
                fmt::format("{}\nnote: the training had made {} steps with `--seed {}`{}",
                            problem.what(), steps(), options_.settings.seed, saved),
                problem.help);
}

Ending Training::learn(const Stop& stop) {
  try {
    return iterate(stop);
  } catch (const Problem& problem) {
    tell_where(problem);
  }
}

/// Whenever it returns or throws, a checkpoint can be written, and resumed with the next iteration
/// or the evaluation that is due.
Ending Training::iterate(const Stop& stop) {
  while (!progressed_.succeeded) {
    if (selection_.is_due(progressed_.curve)) {
      const double begin_s = report_.seconds();
      evaluate_all(progressed_.curve.back());
      evaluating_s_ += report_.seconds() - begin_s;
      if (progressed_.succeeded) {
        report_.show(progressed_.curve, selection_.seen());
        break;
      }
    }
    if (algorithm_->pace.iteration > first_iteration_)
      report_.show(progressed_.curve, selection_.seen());
    if (steps() >= options_.steps) return Ending::steps;
    if (ranks_.is_any(static_cast<bool>(stop))) return Ending::interrupted;
    start_iteration();
    progressed_.curve.push_back(note(algorithm_->iterate()));
  }
  return Ending::success;
}

bool Training::evaluate(CurvePoint& point) {
  return selection_.evaluate(*algorithm_, progressed_.best, point);
}

/// The best policy; if none was evaluated yet, the last one.
void Training::evaluate_at_last() {
  const double begin_s = report_.seconds();
  constexpr double kLong = 1.0;  // s
  if (ranks_.is_first() && (evaluating_s_ > kLong || progressed_.best.parameters.empty()))
    report_.tell_last_evaluation(selection_.episodes_at_last());
  if (progressed_.best.parameters.empty()) {
    CurvePoint unused{};
    evaluate(unused);
  }
  last_ = selection_.evaluate_at_last(*algorithm_, progressed_.best);
  evaluating_s_ += report_.seconds() - begin_s;
}

/// The graph as it is written says what success is; in a stage also how well it does there.
/// Nothing has changed if any of it throws.
void Training::evaluate_all(CurvePoint& point) {
  const std::vector<client::Stage>& stages = library_.description().stages;
  const std::size_t stage = progressed_.curriculum.stage;
  std::optional<Evaluation> in_stage;
  if (stage < stages.size()) in_stage = selection_.evaluate_in(stages[stage].name, *algorithm_);
  progressed_.succeeded = evaluate(point);
  if (!in_stage) return;
  const double success = in_stage->success();
  point.stage_return = in_stage->mean_return;
  if (library_.description().has_success) point.stage_success = success;
  if (progressed_.succeeded || success < stages[stage].success ||
      in_stage->mean_return < stages[stage].mean_return)
    return;
  algorithm_->pace.end_era();
  progressed_.curriculum.go_on(algorithm_->pace.iteration, algorithm_->pace.era);
  progressed_.recent.clear();  // of other episodes
  set_stage();
  if (ranks_.is_first()) report_.tell_stage(progressed_.curve);
}

/// A task may have fewer stages than when a checkpoint was written.
void Training::set_stage() {
  const std::vector<client::Stage>& stages = library_.description().stages;
  const std::size_t stage = progressed_.curriculum.stage;
  algorithm_->set_stage(stage < stages.size() ? stages[stage].name : std::string());
}

void Training::start_iteration() {
  const bool begins_era = algorithm_->pace.since_era == 0;
  if (algorithm_->pace.iteration > first_iteration_) {
    const std::optional<Problem> problem = saving_.save_if_due(begins_era);
    if (problem) report_.warn(problem->what(), "and tries again");
  }
  if (begins_era) {
    algorithm_->begin_era();
  } else if (continues_) {
    algorithm_->go_on();
  }
  continues_ = false;
}

std::string Training::checkpoint() {
  progressed_.iteration = algorithm_->pace.iteration;
  return algorithm_->checkpoint(conditions_, interface_, progressed_);
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
  const bool has_stages = !library_.description().stages.empty();
  return {static_cast<double>(steps()),
          count > 0 ? returns / count : kNothing,
          count > 0 && has_success ? successes / count : kNothing,
          kNothing,
          kNothing,
          algorithm_->deviation(),
          algorithm_->step_size(),
          result.divergence,
          has_stages ? static_cast<double>(progressed_.curriculum.stage) + 1.0 : kNothing};
}

Ended Training::ended(Ending ending) const {
  Spent spent = algorithm_->spent();
  spent.evaluation_s = selection_.spent_s();
  return {.options = options_,
          .description = library_.description(),
          .curve = progressed_.curve,
          .kernels = kernels_.name,
          .steps = steps(),
          .seconds = report_.seconds(),
          .evaluating_seconds = evaluating_s_,
          .spent = spent,
          .done = algorithm_->done(),
          .threads = pool_.size(),
          .ending = ending,
          .has_aim = selection_.has_aim()};
}

void Training::write_policy(const std::string& path) const {
  const Policy best = selection_.policy(*algorithm_, progressed_.best.parameters);
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
  write_files({{path, safetensors_of(best, library_.description(), options_.settings)},
               {golden_path(path), golden_rows(best, kernels_, rows)}});
}

void Training::write_curves() {
  const std::string& name = library_.description().graph;
  report_.write_table(progressed_.curve);
  if (!options_.curve.empty()) write_file(options_.curve, curve_svg(progressed_.curve, name));
}

}  // namespace eagerx::train
