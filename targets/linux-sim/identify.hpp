// Parameters of the graph's objects and delays of their actuators, from a log. What is looked for
// is what the graph draws from a range.
#pragma once

#include <cstdint>
#include <cstdio>
#include <eagerx/message.hpp>
#include <optional>
#include <string>
#include <targets/common/log_file.hpp>
#include <targets/common/run.hpp>
#include <targets/linux-sim/experiment.hpp>
#include <targets/linux-sim/least_squares.hpp>
#include <targets/linux-sim/options.hpp>
#include <targets/linux-sim/text_file.hpp>
#include <type_traits>
#include <vector>

namespace eagerx::linux_sim {

/// One element of a state that the graph draws from a range.
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
  /// What the graph's randomisation can use.
  std::string yaml(const trace_log::Log& log, std::span<const Channel> channels) const;

 private:
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

/// All elements of the states that the graph draws from ranges.
template <class Graph>
std::vector<Parameter> parameters_of() {
  std::vector<Parameter> parameters;
  Graph::for_each_range([&](const char* name, auto member, const auto& space) {
    static_cast<void>(member);
    using Message = std::remove_cvref_t<decltype(space.low)>;
    for (std::size_t i = 0; i < size_of<Message>; ++i) {
      parameters.push_back({name, i, size_of<Message>, std::is_arithmetic_v<Message>,
                            static_cast<double>(element(space.low, i)),
                            static_cast<double>(element(space.high, i))});
    }
  });
  return parameters;
}

template <class Graph>
typename Graph::States states_of(const Trial& trial) {
  typename Graph::States states;
  std::size_t next = 0;
  Graph::for_each_range([&](const char* /*name*/, auto member, const auto& space) {
    auto message = space.low;
    using Scalar = ScalarOf<decltype(message)>;
    for (std::size_t i = 0; i < size_of<decltype(message)>; ++i)
      element(message, i) = static_cast<Scalar>(trial.parameters[next++]);
    states.*member = message;
  });
  return states;
}

/// The log once more.
template <class Graph, class Program>
const std::vector<double>& repeat_log(const trace_log::Log& log, Program& program,
                                      Experiment& experiment, const Trial& trial, bool plain) {
  experiment.begin(plain ? nullptr : &trial);
  const typename Graph::States states = states_of<Graph>(trial);
  for (std::uint32_t episode = 0; episode < log.episodes(); ++episode) {
    experiment.episode(episode);
    program.reset(states);
    const std::uint64_t steps = experiment.steps(episode);
    for (std::uint64_t step = 0; step < steps; ++step) program.step(Graph::zero());
  }
  return experiment.residuals();
}

/// Writes the YAML to a file, or prints it.
int finish_identification(const Options& options, const std::string& report,
                          const std::string& yaml);

template <class Graph, class Program>
int identify_with(const Options& options, const trace_log::Log& log, Program& program,
                  std::string& problem) {
  Experiment experiment;
  if (!experiment.prepare(log, Graph::kChannels, options.identify_sensors,
                          options.identify_horizon_s, problem))
    return kBadFile;
  std::vector<Parameter> parameters = parameters_of<Graph>();
  program.trace.measure(&experiment);
  Trial middle;
  for (const Parameter& parameter : parameters)
    middle.parameters.push_back((parameter.low + parameter.high) / 2);
  repeat_log<Graph>(log, program, experiment, middle, true);
  experiment.find_actuators();
  repeat_log<Graph>(log, program, experiment, middle, true);
  Identification identification(
      experiment, parameters, [&](const Trial& trial) -> const auto& {
        return repeat_log<Graph>(log, program, experiment, trial, false);
      });
  const Channel* engine = nullptr;
  for (const Channel& channel : Graph::kChannels) {
    if (channel.publisher == Publisher::engine) engine = &channel;
  }
  const double tick_s =
      static_cast<double>(engine->rate_den) / static_cast<double>(engine->rate_num);
  if (!identification.find(tick_s, options.identify_delay_s, problem)) return kBadFile;
  return finish_identification(options, identification.report(log, Graph::kChannels),
                               identification.yaml(log, Graph::kChannels));
}

}  // namespace eagerx::linux_sim
