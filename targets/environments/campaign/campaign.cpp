#include "targets/environments/campaign/campaign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <mutex>
#include <optional>
#include <thread>

#include "targets/environments/campaign/journal.hpp"
#include "targets/environments/campaign/progress.hpp"
#include "targets/environments/campaign/report.hpp"
#include "targets/environments/campaign/runner.hpp"
#include "targets/environments/client/files.hpp"
#include "targets/environments/client/problem.hpp"
#include "targets/environments/client/team.hpp"

namespace eagerx::campaign {
namespace {

/// FNV-1a of a file.
std::uint64_t hash_of(const std::string& path) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : client::read_file(path))
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return hash;
}

/// All that results depend on, in a line.
std::string identity_of(const std::string& library, const Plan& plan) {
  std::string text = fmt::format("library {:016x} seed {} runs {} steps {}", hash_of(library),
                                 plan.seed, plan.runs, plan.longest);
  for (const Variation& one : plan.variations)
    text += fmt::format(" {}={}:{}", one.name, one.low, one.high);
  return text;
}

class Campaign {
 public:
  Campaign(const Options& options, const client::Library& library)
      : options_(options),
        library_(library),
        plan_(make_plan(library.description(), options.seed, options.runs, options.steps,
                        options.variations)),
        runner_(library, plan_),
        results_(plan_.runs, plan_.columns.size()),
        done_(plan_.chunks()) {
    if (!journal_path().empty()) {
      journal_.emplace(journal_path(), identity_of(options.library, plan_));
      if (options.resume.empty()) {
        journal_->begin();
      } else {
        done_ = journal_->resume(plan_, results_);
      }
    }
  }

  int run(const volatile int& interrupted) {
    Progress progress(plan_.runs, options_.is_quiet);
    std::uint32_t runs = 0, successes = 0;
    for (std::uint32_t chunk = 0; chunk < plan_.chunks(); ++chunk) {
      if (done_[chunk]) note(chunk, runs, successes);
    }
    progress.begin(runs);
    client::Team team(threads());
    team.run(plan_.chunks(), [&](std::size_t part) {
      const auto chunk = static_cast<std::uint32_t>(part);
      if (done_[chunk] || interrupted != 0) return;
      const Results some = runner_.run(chunk);
      const std::lock_guard lock(mutex_);
      put(plan_, chunk, some, results_);
      if (journal_) journal_->add(chunk, some);
      note(chunk, runs, successes);
      progress.show(runs, successes);
    });
    progress.finish();
    if (runs == plan_.runs) return tell();
    fmt::print(stderr, "interrupted after {} of {} runs\n", runs, plan_.runs);
    if (journal_)
      fmt::print(stderr, "help: the same command with `--resume {}` goes on\n", journal_path());
    return kInterrupted;
  }

 private:
  const std::string& journal_path() const {
    return options_.resume.empty() ? options_.checkpoint : options_.resume;
  }

  unsigned threads() const {
    const unsigned wanted = options_.threads != 0
                                ? options_.threads
                                : std::max(1U, std::thread::hardware_concurrency());
    return library_.description().has_threads ? std::min(wanted, plan_.chunks()) : 1;
  }

  void note(std::uint32_t chunk, std::uint32_t& runs, std::uint32_t& successes) const {
    const std::uint32_t first = plan_.first_of(chunk), size = plan_.size_of(chunk);
    for (std::uint32_t run = first; run < first + size; ++run)
      successes += results_.succeeded(run) ? 1U : 0U;
    runs += size;
  }

  int tell() const {
    const Report report{library_.description(), plan_,          results_,
                        options_.replay,        options_.worst, options_.steps != 0};
    if (!options_.csv.empty()) client::write_file(options_.csv, report.csv());
    if (options_.is_quiet) return client::kDone;
    const std::string text = options_.json ? report.json() : report.text();
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
      throw client::Problem(client::kInputOutput, "cannot write to the standard output");
    return client::kDone;
  }

  const Options& options_;
  const client::Library& library_;
  Plan plan_;
  Runner runner_;
  Results results_;
  std::vector<bool> done_;  // [chunks] before this program began
  std::optional<Journal> journal_;
  std::mutex mutex_;
};

}  // namespace

int run_campaign(const Options& options, const client::Library& library,
                 const volatile int& interrupted) {
  return Campaign(options, library).run(interrupted);
}

void check_files(const Options& options) {
  for (const std::string& path : {options.csv, options.checkpoint}) {
    if (!path.empty()) client::check_writable(path);
  }
  if (!options.resume.empty()) client::read_file(options.resume);
}

}  // namespace eagerx::campaign
