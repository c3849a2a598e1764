#include "targets/environments/campaign/runner.hpp"

#include <algorithm>
#include <iterator>

#include "targets/environments/campaign/record.hpp"
#include "targets/environments/client/problem.hpp"
#include "targets/environments/client/rows.hpp"

namespace eagerx::campaign {

/// The environments of a chunk while it runs.
class Runner::Chunk {
 public:
  Chunk(const Runner& runner, std::uint32_t chunk)
      : runner_(runner),
        count_(runner.plan_.size_of(chunk)),
        environments_(runner.library_.functions(), count_, runner.plan_.first_of(chunk),
                      runner.plan_.seed, runner.plan_.longest, EAGERX_DISABLED),
        rows_(runner.library_.description(), count_),
        action_(count_ * runner.library_.description().action_numbers()),
        ended_(count_),
        results_(count_, runner.plan_.width()) {
    begin(runner.plan_.first_of(chunk));
  }

  Results run() {
    const eagerx_rows rows = rows_.pointers();
    for (std::uint32_t running = count_; running != 0;) {
      check(runner_.functions_.act(environments_.handle(), seen(), action_.data()));
      spoil(FaultRow::action, action_, given_);
      static_cast<void>(
          environments_.step(action_.data(), rows));  // returns say what is not finite
      for (std::uint32_t e = 0; e < count_; ++e) running -= note_step(e) ? 1U : 0U;
    }
    note_counts();
    return std::move(results_);
  }

 private:
  void check(int failed) const {
    if (failed == 0) return;
    throw client::Problem(client::kProblems, std::string("the library refuses: ") +
                                                 runner_.library_.functions().error());
  }

  void begin(std::uint32_t first) {
    const Plan& plan = runner_.plan_;
    if (!plan.sampled.empty()) {
      std::vector<float> wanted;  // [count][columns]
      for (std::uint32_t e = 0; e < count_; ++e)
        std::ranges::copy(plan.states_of(first + e), std::back_inserter(wanted));
      check(runner_.functions_.set_states(environments_.handle(), nullptr, wanted.data()));
    }
    environments_.reset(plan.seed, rows_.observation.data());
    std::vector<double> states(count_ * plan.columns.size());  // [count][columns]
    if (!states.empty())
      check(runner_.functions_.get_states(environments_.handle(), states.data()));
    for (std::uint32_t e = 0; e < count_; ++e) begin_run(first, e, states);
  }

  void begin_run(std::uint32_t first, std::uint32_t e, const std::vector<double>& states) {
    const Plan& plan = runner_.plan_;
    double* number = &results_.states[e * results_.width];
    number = std::copy_n(&states[e * plan.columns.size()], plan.columns.size(), number);
    if (plan.faults.empty()) return;
    faults_.push_back(plan.faults_of(first + e));
    for (const target::PlacedFault& fault : faults_.back())
      *number++ = static_cast<double>(*fault.fault.begins);
  }

  /// The agents' inputs: observations with their faults.
  const float* seen() {
    if (faults_.empty()) return rows_.observation.data();
    seen_ = rows_.observation;
    spoil(FaultRow::observation, seen_, shown_);
    return seen_.data();
  }

  /// Puts the faults into the rows of a step; `before` is what stood there a step earlier.
  void spoil(FaultRow kind, std::vector<float>& rows, std::vector<float>& before) {
    if (faults_.empty()) return;
    before.resize(rows.size());
    const std::size_t width = rows.size() / count_;
    for (std::uint32_t e = 0; e < count_; ++e) {
      if (ended_[e] != 0) continue;
      for (std::size_t i = 0; i < width; ++i) {
        float& place = rows[e * width + i];
        place = target::with_faults(faults_[e], static_cast<std::size_t>(kind), i,
                                    results_.steps[e], place, before[e * width + i]);
      }
    }
    before = rows;
  }

  /// Whether the step ended the episode.
  bool note_step(std::uint32_t e) {
    if (ended_[e] != 0) return false;
    results_.returns[e] += rows_.reward[e];
    ++results_.steps[e];
    if (!rows_.ended(e)) return false;
    results_.flags[e] = static_cast<std::uint8_t>((rows_.success[e] != 0 ? kSuccess : 0) |
                                                  (rows_.terminated[e] != 0 ? kTerminated : 0) |
                                                  (rows_.truncated[e] != 0 ? kTruncated : 0));
    return (ended_[e] = 1) == 1;
  }

  void note_counts() {
    const char* text = runner_.functions_.counts(environments_.handle());
    check(text == nullptr ? -1 : 0);
    results_.counts = read_counts(text);
  }

  const Runner& runner_;
  std::uint32_t count_;
  client::Environments environments_;
  client::Rows rows_;  // of the last step
  std::vector<float> action_;
  std::vector<std::vector<target::PlacedFault>> faults_;  // [count], or nothing if there are none
  std::vector<float> seen_;           // observations of a step with their faults
  std::vector<float> shown_, given_;  // what the agents saw and gave a step earlier
  std::vector<std::uint8_t> ended_;
  Results results_;
};

Runner::Runner(const client::Library& library, const Plan& plan)
    : library_(library),
      plan_(plan),
      functions_{library.find<decltype(&eagerx_act)>("eagerx_act"),
                 library.find<decltype(&eagerx_set_states)>("eagerx_set_states"),
                 library.find<decltype(&eagerx_get_exact_states)>("eagerx_get_exact_states"),
                 library.find<decltype(&eagerx_counts)>("eagerx_counts")} {}

std::string Runner::stepping() const {
  const client::Environments first(library_.functions(), plan_.size_of(0), plan_.first_of(0),
                                   plan_.seed, plan_.longest, EAGERX_DISABLED);
  return first.stepping();
}

Results Runner::run(std::uint32_t chunk) const {
  return Chunk(*this, chunk).run();
}

}  // namespace eagerx::campaign
