// Rows of float32 for an external agent: the same columns as those of target
// environments.
#pragma once

#include <cstddef>
#include <runtime/host/base/json.hpp>
#include <string>
#include <targets/linux-sim/fields.hpp>
#include <vector>

namespace eagerx::linux_sim {

/// Columns of fields, which are in the order of the fields' names.
class ExternalColumns {
 public:
  explicit ExternalColumns(const std::vector<Field>& fields);

  /// Of a row.
  std::size_t numbers() const { return numbers_; }
  std::size_t first(std::size_t field) const { return first_[field]; }
  /// Fields in the order of their columns.
  const std::vector<std::size_t>& order() const { return order_; }

 private:
  std::vector<std::size_t> first_, order_;
  std::size_t numbers_ = 0;
};

class ExternalRows {
 public:
  explicit ExternalRows(const Fields& fields);

  std::size_t action_numbers() const { return actions_.numbers(); }
  std::size_t observation_numbers() const { return observations_.numbers(); }
  std::size_t state_numbers() const { return states_.numbers(); }

  /// Puts a row into an Action of the program, and back.
  void read_action(const float* row, void* action) const;
  void write_action(const void* action, float* row) const;
  /// NaN for messages that are not there; 0 in types that have none.
  void write_observation(ObservationRow observation, float* row) const;
  /// The problem of a row of states, or an empty text. `sampled`: whether the graph gives each a
  /// value.
  std::string problem_of_states(const float* row, const bool* sampled) const;
  /// The same for parameters that are set during an episode.
  std::string problem_of_parameters(const float* row) const;
  /// Puts the numbers of a row that are not NaN into `states`.
  void read_states(const float* row, StateRow states) const;

  /// Lists of JSON, as eagerx_describe() of target environments has them.
  void describe_actions(host::Json& json) const { describe(json, fields_.actions, actions_); }
  void describe_observations(host::Json& json) const {
    describe(json, fields_.observations, observations_);
  }
  void describe_states(host::Json& json) const { describe(json, fields_.states, states_); }

 private:
  static void describe(host::Json& json, const std::vector<Field>& fields,
                       const ExternalColumns& columns);

  const Fields& fields_;
  ExternalColumns actions_, observations_, states_;
};

}  // namespace eagerx::linux_sim
