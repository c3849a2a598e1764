#include <cstdio>
#include <cstring>
#include <optional>
#include <runtime/host/trace/log_file.hpp>
#include <runtime/host/trace/replay.hpp>
#include <string>
#include <targets/linux-sim/elements.hpp>
#include <targets/linux-sim/files.hpp>
#include <targets/linux-sim/replay_log.hpp>
#include <targets/linux-sim/say.hpp>
#include <targets/linux-sim/state_record.hpp>
#include <targets/linux-sim/summary.hpp>
#include <vector>

namespace eagerx::linux_sim {
namespace {

class Repetition {
 public:
  Repetition(const Options& options, const trace_log::Log& log, const Fields& fields,
             const ActionTable& table, GraphProgram& program, trace_log::Replay& replay)
      : options_(options),
        log_(log),
        fields_(fields),
        table_(table),
        program_(program),
        facts_(program.facts()),
        replay_(replay),
        states_(fields.states),
        action_(program.action_bytes() / sizeof(std::max_align_t) + 1) {}

  void run() {
    program_.warm_up();
    for (std::uint32_t episode = 0; episode < log_.episodes() && replay_.go_on(); ++episode) {
      const EpisodeKey key{log_.seed, log_.environment, episode};
      program_.sample(key, states_.row());
      repeat_states(log_, episode, fields_.states, states_.row());
      program_.reset(episode, states_.row());
      for (Seq step = 0; replay_.go_on() && replay_.has_step(episode); ++step) {
        if (repeat_settings(log_, episode, step, fields_.states, states_.row()))
          program_.tune(states_.row());
        decide(key, step);
        program_.guard(action_.data());
        take_recorded(episode);
        program_.apply(action_.data());
      }
      replay_.end_episode(episode);
    }
  }

 private:
  /// The agent's action; a file of actions may be shorter than a log.
  void decide(EpisodeKey key, Seq step) {
    if (options_.agent != target::Agent::csv)
      return program_.act(options_.agent, key, step, action_.data());
    if (step >= table_.size()) return program_.zero(action_.data());
    std::memcpy(action_.data(), table_[step], program_.action_bytes());
  }
  /// Takes the log's action instead.
  void take_recorded(std::uint32_t episode) {
    auto* const action = reinterpret_cast<std::byte*>(action_.data());
    for (const Field& field : fields_.actions) {
      const std::string channel = std::string("environment/") + field.name;
      for (std::uint32_t i = 0; i < facts_.channel_count; ++i) {
        if (channel != facts_.channels[i].name) continue;
        with_elements(field.type.scalar, static_cast<void*>(action + field.offset),
                      [&](auto* elements) { replay_.copy(i, episode, elements, field.type.size); });
      }
    }
  }

  const Options& options_;
  const trace_log::Log& log_;
  const Fields& fields_;
  const ActionTable& table_;
  GraphProgram& program_;
  const GraphFacts& facts_;
  trace_log::Replay& replay_;
  StateMemory states_;
  std::vector<std::max_align_t> action_;
};

}  // namespace

int replay_log(const Options& options, const Fields& fields, const ActionTable& table,
               GraphProgram& program) {
  std::string problem;
  const GraphFacts& facts = program.facts();
  const std::optional<trace_log::Log> log = trace_log::read_log_file(options.replay, problem);
  if (!log) return fail(problem, kBadFile);
  trace_log::Replay replay(*log, {facts.channels, facts.channel_count});
  if (!replay.prepare(options.replay_given, program.is_real(), problem))
    return fail(problem, kBadFile);
  program.recorder.follow(&replay);
  Repetition(options, *log, fields, table, program, replay).run();
  std::string text = replay.report(facts.name, facts.engine);
  if (options.hash) text += hash_line(program.hash());
  if (!print(stdout, text)) return kBadFile;
  return replay.divergence() ? kDiverged : kDone;
}

}  // namespace eagerx::linux_sim
