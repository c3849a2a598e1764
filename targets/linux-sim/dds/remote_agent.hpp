// --agent dds: another process is the agent.
#pragma once

#include <cstdint>
#include <memory>
#include <runtime/host/dds/joint_exchange.hpp>
#include <runtime/host/dds/stamp.hpp>
#include <span>
#include <string>
#include <targets/linux-sim/fields.hpp>
#include <targets/linux-sim/graph_program.hpp>
#include <targets/linux-sim/options.hpp>
#include <targets/linux-sim/summary.hpp>
#include <vector>

namespace eagerx::linux_sim {

/// Writes the observations of a step with a unique time, and waits for the actions with this time.
/// Invalid actions are rejected and counted.
class RemoteAgent {
 public:
  /// `zero`: an action of `bytes` that does nothing.
  RemoteAgent(const Options& options, const GraphFacts& facts, const Fields& fields,
              const void* zero, std::size_t bytes);

  /// Empty, or the problem.
  std::string open();
  /// Waits for an agent. Empty, also after a signal, or the problem.
  std::string wait_for_agent();

  void begin(std::uint32_t episode) { episode_ = episode; }
  /// The action of step `step` (from 0). Waits until `until_ns` of the monotonic clock if that is
  /// not 0, after which the last action stays; otherwise up to the agent's time-out.
  const void* act(Seq step, ObservationRow observations, std::int64_t until_ns);
  /// Steps in a row, up to the last, without an action in time.
  std::uint64_t missed_in_a_row() const { return missed_in_a_row_; }

  bool failed() const { return !problem_.empty(); }
  const std::string& problem() const { return problem_; }
  /// Reports rejected actions.
  void finish(Summary& summary);

 private:
  /// An action, and its state in this step.
  struct Input {
    const Field* field;
    std::string topic;
    bool has_come = false;
  };
  struct Output {
    const Field* field;
    std::string topic;
    bool is_written = false;
    std::vector<double> numbers{};  // [most][size]
  };

  /// Writes the remaining observations of this step. False if there is no room for one while
  /// earlier ones are in flight.
  bool write(ObservationRow observations);
  /// Reads actions that have arrived. True once all have.
  bool take_all();
  void check(Input& input, dds::Stamp when, std::span<const double> numbers);
  /// Null, or the counter for the problem of its numbers.
  std::uint64_t* wrong_with(const Field& field, std::span<const double> numbers);
  void look_for_strangers();
  std::string silence(const std::string& what) const;

  const Options& options_;
  const GraphFacts& facts_;
  const Fields& fields_;
  const std::unique_ptr<dds::JointExchange> exchange_ = dds::joint_exchange();
  std::vector<Input> inputs_;
  std::vector<Output> outputs_;
  std::vector<std::max_align_t> action_, wanted_;  // Action objects
  std::uint32_t episode_ = 0;
  std::uint64_t written_ = 0;  // observations, of all episodes
  dds::Stamp now_, before_;
  bool has_answered_ = false;
  std::string frame_, problem_, stranger_;
  std::uint64_t missed_in_a_row_ = 0, missed_ = 0, late_ = 0, others_ = 0;
  std::uint64_t lengths_ = 0, not_finite_ = 0, beyond_ = 0, not_whole_ = 0, strangers_ = 0;
};

}  // namespace eagerx::linux_sim
