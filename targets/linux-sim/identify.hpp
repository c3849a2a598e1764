// `--identify`: the program repeats a log with the trials of runtime/host/identify.
#pragma once

#include <cstdint>
#include <eagerx/channel.hpp>
#include <eagerx/message.hpp>
#include <runtime/host/identify/identification.hpp>
#include <runtime/host/trace/log_file.hpp>
#include <string>
#include <targets/linux-sim/options.hpp>
#include <type_traits>
#include <vector>

namespace eagerx::linux_sim {

/// All elements of the states that the graph draws from ranges.
template <class Graph>
std::vector<identification::Parameter> parameters_of() {
  std::vector<identification::Parameter> parameters;
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
typename Graph::States states_of(const identification::Trial& trial) {
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
                                      identification::Experiment& experiment,
                                      const identification::Trial& trial, bool plain) {
  experiment.begin(plain ? nullptr : &trial);
  const typename Graph::States states = states_of<Graph>(trial);
  const typename Graph::Action zero = Graph::zero();
  for (std::uint32_t episode = 0; episode < log.episodes(); ++episode) {
    experiment.episode(episode);
    program.reset(states);
    const std::uint64_t steps = experiment.steps(episode);
    for (std::uint64_t step = 0; step < steps; ++step) target::apply(program, zero);
  }
  return experiment.residuals();
}

/// Writes the YAML to a file, or prints it.
int finish_identification(const Options& options, const std::string& report,
                          const std::string& yaml);

template <class Graph, class Program>
int identify_with(const Options& options, const trace_log::Log& log, Program& program,
                  std::string& problem) {
  identification::Experiment experiment;
  if (!experiment.prepare(log, Graph::kChannels, options.identify_sensors,
                          options.identify_horizon_s, problem))
    return kBadFile;
  std::vector<identification::Parameter> parameters = parameters_of<Graph>();
  program.trace.measure(&experiment);
  identification::Trial middle;
  for (const identification::Parameter& parameter : parameters)
    middle.parameters.push_back((parameter.low + parameter.high) / 2);
  repeat_log<Graph>(log, program, experiment, middle, true);
  experiment.find_actuators();
  repeat_log<Graph>(log, program, experiment, middle, true);
  identification::Identification found(
      experiment, parameters, [&](const identification::Trial& trial) -> const auto& {
        return repeat_log<Graph>(log, program, experiment, trial, false);
      });
  const Channel* engine = nullptr;
  for (const Channel& channel : Graph::kChannels) {
    if (channel.publisher == Publisher::engine) engine = &channel;
  }
  const double tick_s =
      static_cast<double>(engine->rate_den) / static_cast<double>(engine->rate_num);
  if (!found.find(tick_s, options.identify_delay_s, problem)) return kBadFile;
  return finish_identification(options, found.report(log, Graph::kChannels),
                               found.yaml(log, Graph::kChannels));
}

}  // namespace eagerx::linux_sim
