#include <algorithm>
#include <cstdio>
#include <cstring>
#include <optional>
#include <runtime/host/base/files.hpp>
#include <runtime/host/identify/identification.hpp>
#include <runtime/host/trace/log_file.hpp>
#include <runtime/host/trace/replay.hpp>
#include <string>
#include <targets/linux-sim/elements.hpp>
#include <targets/linux-sim/files.hpp>
#include <targets/linux-sim/identify.hpp>
#include <targets/linux-sim/say.hpp>
#include <vector>

namespace eagerx::linux_sim {
namespace {

using identification::Experiment;
using identification::Trial;

/// All elements of the states that the graph samples from ranges.
std::vector<identification::Parameter> parameters_of(const std::vector<Field>& ranges) {
  std::vector<identification::Parameter> parameters;
  for (const Field& field : ranges) {
    const MessageType& type = field.type;
    for (std::size_t i = 0; i < type.size; ++i)
      parameters.push_back({field.name, i, type.size, type.is_scalar(),
                            number_of(type.scalar, field.low, i),
                            number_of(type.scalar, field.high, i)});
  }
  return parameters;
}

/// Repeats a log, again and again.
class Trials {
 public:
  Trials(const trace_log::Log& log, const Fields& fields, GraphProgram& program,
         Experiment& experiment)
      : log_(log),
        fields_(fields),
        program_(program),
        experiment_(experiment),
        states_(fields.states),
        zero_(program.action_bytes() / sizeof(std::max_align_t) + 1),
        action_(zero_.size()) {
    program.zero(zero_.data());
  }

  const std::vector<double>& run(const Trial& trial, bool plain) {
    experiment_.begin(plain ? nullptr : &trial);
    put(trial);
    for (std::uint32_t episode = 0; episode < log_.episodes(); ++episode) {
      experiment_.episode(episode);
      program_.reset(episode, states_.row());
      const std::uint64_t steps = experiment_.steps(episode);
      for (std::uint64_t step = 0; step < steps; ++step) {
        action_ = zero_;
        program_.apply(action_.data());
      }
    }
    return experiment_.residuals();
  }

 private:
  void put(const Trial& trial) {
    const StateRow row = states_.row();
    std::size_t next = 0;
    for (const Field& range : fields_.ranges) {
      const auto state = std::ranges::find_if(fields_.states, [&](const Field& each) {
        return std::strcmp(each.name, range.name) == 0;
      });
      const auto at = static_cast<std::size_t>(state - fields_.states.begin());
      row.has_value[at] = true;
      with_elements(range.type.scalar, row.messages[at], [&](auto* elements) {
        for (std::size_t i = 0; i < range.type.size; ++i)
          elements[i] =
              static_cast<std::remove_reference_t<decltype(*elements)>>(trial.parameters[next++]);
      });
    }
  }

  const trace_log::Log& log_;
  const Fields& fields_;
  GraphProgram& program_;
  Experiment& experiment_;
  StateMemory states_;
  std::vector<std::max_align_t> zero_, action_;
};

/// Writes the YAML to a file, or prints it.
int finish(const Options& options, const std::string& report, const std::string& yaml) {
  if (options.identify_out.empty()) return print(stdout, report + yaml) ? kDone : kBadFile;
  const int error = host::write_whole(options.identify_out, yaml);
  if (error == 0) return print(stdout, report) ? kDone : kBadFile;
  return fail(
      "error: cannot write `" + options.identify_out + "`: " + host::problem_of_writing(error),
      kBadFile);
}

int identify_with(const Options& options, const trace_log::Log& log, const Fields& fields,
                  GraphProgram& program, std::string& problem) {
  const GraphFacts& facts = program.facts();
  const std::span<const Channel> channels(facts.channels, facts.channel_count);
  Experiment experiment;
  if (!experiment.prepare(log, {channels, facts.engine, facts.rate_num, facts.rate_den},
                          options.identify_sensors, options.identify_horizon_s, problem))
    return kBadFile;
  std::vector<identification::Parameter> parameters = parameters_of(fields.ranges);
  program.recorder.follow(&experiment);
  Trials trials(log, fields, program, experiment);
  Trial middle;
  for (const identification::Parameter& parameter : parameters)
    middle.parameters.push_back((parameter.low + parameter.high) / 2);
  trials.run(middle, true);
  experiment.find_actuators();
  trials.run(middle, true);
  identification::Identification found(
      experiment,
      parameters, [&](const Trial& trial) -> const auto& { return trials.run(trial, false); });
  const auto engine = std::ranges::find(channels, Publisher::engine, &Channel::publisher);
  const double tick_s =
      static_cast<double>(engine->rate_den) / static_cast<double>(engine->rate_num);
  if (!found.find(tick_s, options.identify_delay_s, problem)) return kBadFile;
  return finish(options, found.report(log, channels), found.yaml(log, channels));
}

}  // namespace

int identify(const Options& options, const Fields& fields, GraphProgram& program) {
  std::string problem;
  const GraphFacts& facts = program.facts();
  const std::optional<trace_log::Log> log = trace_log::read_log_file(options.identify, problem);
  if (!log) return fail(problem, kBadFile);
  const trace_log::Replay same(*log, {facts.channels, facts.channel_count});
  if (!same.fits(problem)) return fail(problem, kBadFile);
  if (program.is_real())
    return fail(
        "error: parameters are identified in the program of a simulation\n"
        "help: generate the graph for OdeEngine, with `--engine OdeEngine`",
        kBadUsage);
  if (facts.waits_in_resets)
    return fail(
        "error: parameters are identified in a program without reset nodes\n"
        "help: leave them out in a variant of the graph: connect what they pass on directly, and "
        "set the states",
        kBadUsage);
  program.warm_up();
  const int code = identify_with(options, *log, fields, program, problem);
  return problem.empty() ? code : fail(problem, code);
}

}  // namespace eagerx::linux_sim
