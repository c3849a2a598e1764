// Rows of states that a caller has set: their valid values, and when they apply.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <targets/environments/base/columns.hpp>
#include <vector>

namespace eagerx::environments {

/// A state of the graph. `low` and `high` [elements] are its space.
struct StateField {
  const char* name = nullptr;
  std::vector<float> low, high;
  bool sampled = false;  // whether a reset samples it
  bool tunable = false;  // whether an episode can change it
};

/// The states of a graph, in rows of numbers; NaN: not set.
class StateRows {
 public:
  Columns columns;

  void add(StateField field);
  /// Behind the last add().
  void arrange() { columns.arrange(); }

  /// Throw Problem for rows [environments][numbers] of which one that is meant is wrong: for the
  /// next episode, or while one runs. Null means all.
  void check(std::uint32_t environments, const std::uint8_t* mask, const float* rows) const;
  void check_tuning(std::uint32_t environments, const std::uint8_t* mask, const float* rows) const;

  /// Names of those that an episode can change, as JSON's list.
  std::string describe_tunable() const;

 private:
  using ProblemOf = std::string (StateRows::*)(const float* row) const;
  void check_each(std::uint32_t environments, const std::uint8_t* mask, const float* rows,
                  ProblemOf what_is_wrong) const;
  std::string problem_of(const float* row) const;
  std::string problem_of_tuning(const float* row) const;

  std::vector<StateField> fields_;
};

/// States that are set for environments' next episodes, instead of sampled ones. Allocates with the
/// first set().
class SetRows {
 public:
  /// `states` stay valid.
  explicit SetRows(const StateRows& states) : states_(states) {}

  /// Rows for the next episodes of `environments`. Throws Problem, with nothing changed.
  void set(std::uint32_t environments, const std::uint8_t* mask, const float* rows);
  /// An episode of environment `k` begins.
  void begin(std::uint32_t k) {
    if (!next_.empty()) take_next(k);
  }
  /// The values set for its current episode; null: none.
  const float* row(std::uint32_t k) const {
    return now_.empty() ? nullptr : now_.data() + k * states_.columns.numbers();
  }

 private:
  void take_next(std::uint32_t k);

  const StateRows& states_;
  std::vector<float> now_, next_;  // [environments][state numbers] or empty; NaN: sampled
};

}  // namespace eagerx::environments
