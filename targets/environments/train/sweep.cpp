#include "targets/environments/train/sweep.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <ctime>
#include <mutex>
#include <optional>
#include <runtime/host/base/counted.hpp>
#include <runtime/host/base/hash.hpp>
#include <utility>
#include <vector>

#include "targets/environments/train/checkpoint.hpp"
#include "targets/environments/train/export.hpp"
#include "targets/environments/train/parallel_runs.hpp"
#include "targets/environments/train/sweep_results.hpp"
#include "targets/environments/train/sweep_table.hpp"
#include "targets/environments/train/training.hpp"

namespace eagerx::train {
namespace {

double seconds_of(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

Score score_of(const SweepRow& row) {
  const double episodes = static_cast<double>(std::max<std::uint64_t>(row.episodes, 1));
  return {static_cast<double>(row.successes) / episodes, row.mean_return};
}

/// "learning_rate=0.001 clip=0.2, seed 2"
std::string name_of(const SweepRow& row) {
  return fmt::format("{}, seed {}", row.settings, row.seed);
}

class Sweep {
 public:
  Sweep(const Options& options, const Library& library)
      : options_(options), library_(library), results_(options.results) {
    checked(library);
    std::string files = read_file(options.library);
    if (!options.from.empty()) files += read_file(options.from);
    if (!options.failure_replay.empty()) files += read_file(options.failure_replay);
    for (const std::string& log : options.replay) files += read_file(log);
    const std::uint64_t hash = host::fnv1a(files);
    Options base = options;
    base.cases.clear();
    base.is_quiet = true;
    for (std::string* path : {&base.output, &base.csv}) path->clear();
    for (const Case& one : options.cases) {
      for (std::uint64_t i = 0; i < options.seeds; ++i) add_job(base, one, i, hash);
    }
    parallel_ = parallel_runs(options, library, todo_.size());
  }

  int run(const Interrupt& is_interrupted) {
    if (!options_.is_quiet) tell_beginning();
    train_in_parallel(todo_.size(), parallel_.at_once, is_interrupted,
                      [&](std::size_t i, const Stop& stop) { train(jobs_[todo_[i]], stop); });
    if (!todo_.empty()) results_.write();  // what a full disk has left out
    const std::vector<SweepCase> cases = cases_now();
    if (!options_.csv.empty()) write_file(options_.csv, sweep_csv(cases));
    if (!options_.is_quiet) print(sweep_text(cases, library_.description().has_success));
    tell_best();
    if (done_ == jobs_.size()) return kDone;
    fmt::print(stderr, "interrupted after {} of {}\nhelp: the same command continues\n", done_,
               host::counted(jobs_.size(), "training"));
    return kInterrupted;
  }

 private:
  struct Job {
    Options options;
    SweepRow row;  // what is known of it before it is made
  };

  void add_job(const Options& base, const Case& one, std::uint64_t i, std::uint64_t files) {
    Job job{base, {}};
    job.options.settings = one.settings;
    job.options.settings.seed += i;
    job.row.settings = one.words;
    job.row.seed = job.options.settings.seed;
    job.row.training = fmt::format(
        "{:016x}",
        host::fnv1a(fmt::format("{:016x}; steps {}; {}", files, options_.steps,
                                conditions(job.options.settings, library_.description().hash))));
    const SweepRow* known = results_.find(job.row.training);
    if (known == nullptr) {
      todo_.push_back(jobs_.size());
    } else {
      ++done_;
      note_best(*known);
    }
    jobs_.push_back(std::move(job));
  }

  void tell_beginning() const {
    fmt::print(stderr, "{}, {} each: {}", host::counted(options_.cases.size(), "setting"),
               host::counted(options_.seeds, "seed"), host::counted(jobs_.size(), "training"));
    if (done_ != 0) fmt::print(stderr, ", {} of them in `{}` already", done_, options_.results);
    fmt::print(stderr, "; {} at a time\n", parallel_.at_once);
  }

  void train(const Job& job, const Stop& stop) {
    Options options = job.options;
    options.threads = parallel_.at_once > 1 ? 1 : parallel_.threads;
    const clockid_t clock =
        parallel_.at_once > 1 ? CLOCK_THREAD_CPUTIME_ID : CLOCK_PROCESS_CPUTIME_ID;
    const double begun_s = seconds_of(clock);
    SweepRow row = job.row;
    std::optional<Training> training;
    try {
      training.emplace(options, library_);
      const int code = training->run(stop);
      if (code == kInterrupted) return;
      const Evaluation& last = training->evaluation();
      row.succeeds = code == kDone;
      row.steps = static_cast<std::uint64_t>(training->curve().back().steps);
      row.successes = last.successes;
      row.episodes = last.episodes;
      row.mean_return = last.mean_return;
    } catch (const Problem& problem) {
      if (problem.code != kProblems) throw;
      row.problem = problem.what();  // with these settings; others may go well
    }
    row.processor_s = seconds_of(clock) - begun_s;
    add(std::move(row), training);
  }

  /// The policy first: a row says that all of its training is done.
  void add(SweepRow row, const std::optional<Training>& training) {
    const std::lock_guard lock(mutex_);
    if (note_best(row)) {
      training->write_policy(options_.output);
      is_written_ = true;
    }
    ++done_;
    if (!options_.is_quiet) tell(row);
    const std::string problem = results_.add(std::move(row));
    if (!problem.empty())
      fmt::print(stderr, "warning: {}; the sweep continues and tries again\n", problem);
  }

  /// Whether it is the best so far.
  bool note_best(const SweepRow& row) {
    if (!row.problem.empty()) return false;
    if (best_ && !score_of(row).is_better_than(score_of(*best_))) return false;
    best_ = row;
    return true;
  }

  void tell(const SweepRow& row) const {
    const std::string head = fmt::format("{} of {}: {}: ", done_, jobs_.size(), name_of(row));
    if (!row.problem.empty()) return fmt::print(stderr, "{}{}\n", head, row.problem);
    const std::string success = library_.description().has_success
                                    ? fmt::format("{} of {} succeed, ", row.successes, row.episodes)
                                    : "";
    fmt::print(stderr, "{}{}return {:.4g}, {} steps, {:.3g} s\n", head, success, row.mean_return,
               rounded(static_cast<double>(row.steps)), row.processor_s);
  }

  std::vector<SweepCase> cases_now() const {
    std::vector<SweepCase> cases;
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      if (i % options_.seeds == 0) cases.push_back({jobs_[i].row.settings, {}});
      const SweepRow* row = results_.find(jobs_[i].row.training);
      if (row != nullptr) cases.back().rows.push_back(row);
    }
    return cases;
  }

  void tell_best() const {
    if (!best_ || options_.is_quiet) return;
    print(is_written_
              ? fmt::format("written: {}, the policy of {}\n", options_.output, name_of(*best_))
              : fmt::format("the best policy, of {}, was written when it was trained\n",
                            name_of(*best_)));
  }

  const Options& options_;
  const Library& library_;
  SweepResults results_;
  std::vector<Job> jobs_;          // [cases][seeds]
  std::vector<std::size_t> todo_;  // which of them
  ParallelRuns parallel_{1, 1};
  std::mutex mutex_;  // of what stands below, and of results
  std::size_t done_ = 0;
  std::optional<SweepRow> best_;
  bool is_written_ = false;  // its policy, by this program
};

}  // namespace

void check_files_of_sweep(const Options& options) {
  claim_output(options.output);
  claim_output(golden_path(options.output));
  if (!options.csv.empty()) claim_output(options.csv);
  check_writable(options.results);  // several sweeps may add rows to it
  const SweepResults known(options.results);
  if (!options.failure_replay.empty()) read_file(options.failure_replay);
  const std::string learnt = options.from.empty() ? std::string() : read_file(options.from);
  for (const Case& one : options.cases) {
    try {
      if (!options.from.empty()) check_begun_from(learnt, options.from, one.settings);
    } catch (const Problem& problem) {
      throw in_words_of(problem, options, one.words);
    }
  }
  for (const std::string& log : options.replay) read_file(log);
}

int train_sweep(const Options& options, const Library& library, const Interrupt& is_interrupted) {
  return Sweep(options, library).run(is_interrupted);
}

}  // namespace eagerx::train
