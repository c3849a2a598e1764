#include "targets/environments/campaign/campaign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <mutex>
#include <optional>
#include <runtime/host/base/counted.hpp>
#include <runtime/host/base/hash.hpp>
#include <runtime/host/base/thread_pool.hpp>
#include <stop_token>
#include <string_view>
#include <thread>

#include "targets/environments/campaign/journal.hpp"
#include "targets/environments/campaign/progress.hpp"
#include "targets/environments/campaign/record.hpp"
#include "targets/environments/campaign/report.hpp"
#include "targets/environments/campaign/runner.hpp"
#include "targets/environments/client/files.hpp"
#include "targets/environments/client/problem.hpp"

namespace eagerx::campaign {
namespace {

/// All that results depend on, in a line.
std::string identity_of(const std::string& library, const Plan& plan) {
  std::string text =
      fmt::format("library {:016x} seed {} runs {} steps {}",
                  host::fnv1a(client::read_file(library)), plan.seed, plan.runs, plan.longest);
  for (const Variation& one : plan.variations)
    text += fmt::format(" {}={}:{}", one.name, one.low, one.high);
  for (const target::PlacedFault& one : plan.faults) text += " " + text_of(one.fault);
  return text;
}

class Campaign {
 public:
  Campaign(const Options& options, const client::Library& library, Ranks& ranks)
      : options_(options),
        library_(library),
        ranks_(ranks),
        plan_(make_plan(library.description(), options.seed, options.runs, options.steps,
                        options.variations, options.faults)),
        runner_(library, plan_),
        results_(ranks.is_first() ? plan_.runs : 0, plan_.width()),
        done_(plan_.chunks(), '\0'),
        progress_(plan_.runs, options.is_quiet || !ranks.is_first()) {
    if (ranks_.is_first() && !journal_path().empty()) {
      journal_.emplace(journal_path(), identity_of(options.library, plan_));
      if (options.resume.empty()) {
        journal_->begin();
      } else {
        const Journal::Found found = journal_->resume(plan_, results_);
        std::ranges::copy(found.done, done_.begin());
        tell_of_damage(found);
      }
    }
    done_ = ranks_.share(std::move(done_));
  }

  int run(const host::Interrupt& interrupted) {
    if (!options_.is_quiet && ranks_.is_first())
      fmt::print(stderr, "{} at a time {} {}\n", host::counted(plan_.size_of(0), "environment"),
                 plan_.size_of(0) == 1 ? "steps" : "step", runner_.stepping());
    return ranks_.is_first() ? collect(interrupted) : contribute(interrupted);
  }

 private:
  /// Also if it is quiet: hours of work may be lost.
  void tell_of_damage(const Journal::Found& found) const {
    if (found.damaged_bytes == 0) return;
    std::uint32_t runs = 0;
    for (std::uint32_t chunk = 0; chunk < plan_.chunks(); ++chunk)
      runs += found.done[chunk] ? 0U : plan_.size_of(chunk);
    fmt::print(
        stderr,
        "warning: `{}` {} at byte {} ({} bytes are left out): {} of {} runs are not in it and "
        "are done now\n",
        journal_path(), found.is_cut_off ? "is cut off" : "is damaged", found.first_damaged,
        found.damaged_bytes, runs, plan_.runs);
  }

  /// This rank's share of the chunks. `add(chunk, results)` by one thread at a time.
  template <class Add>
  void compute(const host::Interrupt& interrupted, const Add& add) {
    host::ThreadPool pool(threads(), host::ThreadPool::Size::at_most);
    pool.run_parts(plan_.chunks(), [&](std::size_t part) {
      const auto chunk = static_cast<std::uint32_t>(part);
      if (done_[chunk] != 0 || interrupted || chunk % ranks_.size() != ranks_.rank()) return;
      const Results some = runner_.run(chunk);
      const std::lock_guard lock(mutex_);
      add(chunk, some);
    });
  }

  /// Nothing is the last that a rank sends.
  int contribute(const host::Interrupt& interrupted) {
    compute(interrupted,
            [&](std::uint32_t chunk, const Results& some) { ranks_.send(record_of(chunk, some)); });
    ranks_.send({});
    return client::kDone;
  }

  int collect(const host::Interrupt& interrupted) {
    for (std::uint32_t chunk = 0; chunk < plan_.chunks(); ++chunk) {
      if (done_[chunk] != 0) note(chunk);
    }
    progress_.begin(runs_);
    {
      std::exception_ptr failure;
      std::jthread listener([&](const std::stop_token& token) {
        try {
          listen(token);
        } catch (...) {
          failure = std::current_exception();
        }
      });
      compute(interrupted, [&](std::uint32_t chunk, const Results& some) { add(chunk, some); });
      listener.join();
      if (failure) std::rethrow_exception(failure);
    }
    progress_.finish();
    if (runs_ == plan_.runs) return tell();
    fmt::print(stderr, "interrupted after {} of {} runs\n", runs_, plan_.runs);
    if (journal_)
      fmt::print(stderr, "help: continue with the same command and `--resume {}`\n",
                 journal_path());
    return client::kInterrupted;
  }

  /// Until all other ranks have sent their last. Asks now and then: MPI waits with a whole core.
  void listen(const std::stop_token& token) {
    constexpr std::chrono::milliseconds kPause(1);
    for (std::uint32_t others = ranks_.size() - 1; others != 0 && !token.stop_requested();) {
      const std::optional<std::string> bytes = ranks_.take();
      if (!bytes) {
        std::this_thread::sleep_for(kPause);
      } else if (bytes->empty()) {
        --others;
      } else {
        std::string_view left = *bytes;
        const auto record = take_record(left, plan_);
        if (!record) throw client::Problem(client::kInputOutput, "a rank has sent damaged results");
        const std::lock_guard lock(mutex_);
        add(record->chunk, record->results);
      }
    }
  }

  void add(std::uint32_t chunk, const Results& some) {
    put(plan_, chunk, some, results_);
    if (journal_) journal_->add(record_of(chunk, some));
    note(chunk);
    progress_.show(runs_, successes_);
  }

  const std::string& journal_path() const {
    return options_.resume.empty() ? options_.checkpoint : options_.resume;
  }

  unsigned threads() const {
    const unsigned wanted = options_.threads != 0 ? options_.threads : host::usable_cores();
    return library_.description().has_threads ? std::min(wanted, plan_.chunks()) : 1;
  }

  void note(std::uint32_t chunk) {
    const std::uint32_t first = plan_.first_of(chunk), size = plan_.size_of(chunk);
    for (std::uint32_t run = first; run < first + size; ++run)
      successes_ += results_.succeeded(run) ? 1U : 0U;
    runs_ += size;
  }

  int tell() const {
    const Report report{library_.description(), plan_,          results_,
                        options_.replay,        options_.worst, options_.steps != 0};
    if (!options_.csv.empty()) client::write_file(options_.csv, report.csv());
    if (options_.is_quiet) return client::kDone;
    client::print(options_.json ? report.json() : report.text());
    return client::kDone;
  }

  const Options& options_;
  const client::Library& library_;
  Ranks& ranks_;
  Plan plan_;
  Runner runner_;
  Results results_;   // in rank 0
  std::string done_;  // [chunks] not 0: before this program began
  std::optional<Journal> journal_;
  Progress progress_;
  std::mutex mutex_;  // of what stands below, and of all output about results
  std::uint32_t runs_ = 0, successes_ = 0;
};

}  // namespace

int run_campaign(const Options& options, const client::Library& library, Ranks& ranks,
                 const host::Interrupt& interrupted) {
  return Campaign(options, library, ranks).run(interrupted);
}

void check_files(const Options& options) {
  for (const std::string& path : {options.csv, options.checkpoint}) {
    if (!path.empty()) client::claim_output(path);
  }
  if (!options.checkpoint.empty()) refuse_full(options.checkpoint);
  if (!options.resume.empty()) client::read_file(options.resume);
}

}  // namespace eagerx::campaign
