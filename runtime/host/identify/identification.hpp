// Parameters of the graph's objects and delays of their actuators, from a log. What is looked for
// is what the graph samples from a range.
#pragma once

#include <cstdint>
#include <runtime/host/identify/experiment.hpp>
#include <runtime/host/identify/least_squares.hpp>
#include <runtime/host/trace/log_file.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace eagerx::identification {

/// One element of a state that the graph samples from a range.
struct Parameter {
  std::string state;  // "pendulum.model_parameters"
  std::size_t element = 0, size = 0;
  bool is_scalar = false;
  double low = 0.0, high = 0.0;
  // found
  bool matters = false;  // whether the log's sensors depend on it
  double value = 0.0, deviation = 0.0;
};

struct Delay {
  std::uint32_t channel = 0;  // of the actuator
  double value_s = 0.0, deviation_s = 0.0;
};

/// Finds parameters and delays; `run` repeats the log with a trial.
class Identification {
 public:
  Identification(Experiment& experiment, std::vector<Parameter>& parameters, LeastSquares::Run run)
      : experiment_(experiment), parameters_(parameters), run_(std::move(run)) {}

  /// `tick_s`: the engine's period. False: `problem` says why not.
  bool find(double tick_s, double longest_delay_s, std::string& problem);

  const std::vector<Delay>& delays() const { return delays_; }
  /// Lines for people.
  std::string report(const trace_log::Log& log, std::span<const Channel> channels) const;
  /// The ranges for the graph's randomization.
  std::string yaml(const trace_log::Log& log, std::span<const Channel> channels) const;

 private:
  bool mark_parameters(double state);
  bool choose_parameters(std::string& problem);
  const std::vector<double>& run_chosen(const Trial& trial);
  bool find_delay(std::size_t actuator, double most, LeastSquares& solver, Trial& trial) const;

  Experiment& experiment_;
  std::vector<Parameter>& parameters_;
  LeastSquares::Run run_;
  std::vector<std::size_t> chosen_;  // of the parameters: those that matter
  Trial full_;
  std::vector<Delay> delays_;
  std::vector<double> leftover_;
  std::vector<bool> counts_;
};

}  // namespace eagerx::identification
