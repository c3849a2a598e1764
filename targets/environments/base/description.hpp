// Texts about a graph's environments.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>

namespace eagerx::environments {

/// The goals of a stage: a share of the episodes, a mean return. Negative infinity: no goal.
struct Until {
  double success, mean_return;
};

/// Texts are JSON unless stated otherwise.
struct TaskDescription {
  std::span<const char* const> terms;
  bool success = false;
  std::uint64_t episode_steps = 0;
  std::string critic, stages;
};
struct Description {
  const char* generator;  // its version
  const char* graph;
  const char* engine;
  const char* agent;
  double rate_hz;
  const char* isa;
  std::uint32_t lanes;
  const char* why_no_lanes;  // null if there are some
  std::uint64_t program;     // Graph::kGraphHash, which also changes with engine and policy
  std::string observations, actions, states, tunable, task, render;
};

/// The text of eagerx_describe().
std::string describe(const Description& description);
std::string describe_task(const TaskDescription& task);
/// [{"name": "near", "success": 0.9, "return": null}]
std::string describe_stages(std::span<const char* const> names, std::span<const Until> until);
std::string describe_render(double rate_hz);

/// Throws Problem: unknown stage.
[[noreturn]] void refuse_stage(const std::string& name, std::span<const char* const> known);

/// Number of lanes of a SIMD group; 0: not vectorized.
struct UsedSimd {
  std::uint32_t lanes;
  const char* isa;
};
/// How the environments of a batch are stepped, and the reason if that is slower than possible.
/// `used`: the SIMD groups for `environments` of them, `widest`: those for many. `graph_has_none`:
/// why the graph is not vectorized; empty if it is.
std::string stepping_text(UsedSimd used, UsedSimd widest, std::uint32_t environments, bool draws,
                          const std::string& graph_has_none);

/// Sums of nonzero counts.
class Counts {
 public:
  void add(const char* name, std::uint64_t count) {
    if (count != 0) add_to(name, count);
  }
  /// {"name": count}
  std::string text() const;

 private:
  void add_to(const char* name, std::uint64_t count);

  std::map<std::string, std::uint64_t> sums_;
};

}  // namespace eagerx::environments
