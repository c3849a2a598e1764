// --fault: injects faults into the agent's observations and actions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/rate.hpp>
#include <string>
#include <targets/common/fault.hpp>
#include <targets/linux-sim/fields.hpp>
#include <vector>

namespace eagerx::linux_sim {

/// Faults between a graph and its agent. They do not change the messages of the graph.
class AgentFaults {
 public:
  explicit AgentFaults(const Fields& fields);

  /// The problem of `texts`, or nothing.
  std::string read(const std::vector<std::string>& texts);
  bool empty() const { return faults_.empty(); }

  /// The agent's view of the observations of a step. Valid until the next call.
  ObservationRow seen(Seq step, ObservationRow observations);
  /// Replaces the agent's action.
  void given(Seq step, void* action);

 private:
  bool is_silent(std::size_t field, Seq step) const;
  void put(std::size_t field, std::size_t size, Seq step, const void* now);

  const Fields& fields_;
  std::vector<target::FaultPlace> places_;  // observations, then actions
  std::vector<target::PlacedFault> faults_;
  MessageRows seen_, given_;          // what the agent saw and gave last
  std::vector<std::uint32_t> sizes_;  // [observations] messages of it
};

}  // namespace eagerx::linux_sim
