#include <cstdio>
#include <eagerx/version.hpp>
#include <optional>
#include <runtime/host/base/handover.hpp>
#include <runtime/host/base/hash.hpp>
#include <runtime/host/base/interrupt.hpp>
#include <runtime/host/base/number.hpp>
#include <string>
#include <targets/linux-sim/action_file.hpp>
#include <targets/linux-sim/channel_names.hpp>
#include <targets/linux-sim/describe.hpp>
#include <targets/linux-sim/faults.hpp>
#include <targets/linux-sim/fields.hpp>
#include <targets/linux-sim/files.hpp>
#include <targets/linux-sim/float_environment.hpp>
#include <targets/linux-sim/graph_program.hpp>
#include <targets/linux-sim/identify.hpp>
#include <targets/linux-sim/measures.hpp>
#include <targets/linux-sim/options.hpp>
#include <targets/linux-sim/reconnect.hpp>
#include <targets/linux-sim/replay_log.hpp>
#include <targets/linux-sim/say.hpp>
#include <targets/linux-sim/session.hpp>
#include <targets/linux-sim/spaces.hpp>
#include <targets/linux-sim/split.hpp>
#include <targets/linux-sim/state_settings.hpp>
#include <variant>
#include <vector>

namespace eagerx::linux_sim {

int fail(const std::string& text, int exit_code) {
  std::fputs((text + "\n").c_str(), stderr);
  return exit_code;
}

void say_note(const std::string& text) {
  std::fputs(("note: " + text + "\n").c_str(), stderr);
}

void say_other_spelling(const std::string& written, const std::string& name) {
  say_note("`" + written + "` is `" + name + "` here");
}

namespace {

int show_help(const char* program_name, const Options& defaults, const Fields& fields,
              const GraphProgram& program) {
  const GraphFacts& facts = program.facts();
  const double rate_hz = static_cast<double>(facts.rate_num) / static_cast<double>(facts.rate_den);
  std::string text = "Usage: " + std::string(program_name) + " [OPTION…]\n" +
                     (program.is_real() ? "Runs" : "Simulates") + " the graph `" + facts.name +
                     "` on " + facts.engine + " at " + host::number_text(rate_hz) + " Hz.\n\n";
  text += describe(fields);
  text += "Options (defaults in brackets):\n" + options_help(defaults);
  return print(stdout, text) ? kDone : kBadFile;
}

/// Compares the policy's answers with those that the generator computed.
int self_test(const GraphProgram& program) {
  const GraphFacts& facts = program.facts();
  if (!program.policies_answer()) {
    return fail(
        "error: this machine's answers of the policy differ from the generator's\n"
        "help: build with the flags of the runtime: no fast-math, no contraction",
        kSelfTestFailed);
  }
  const std::string text =
      facts.self_test_rows == 0
          ? "this program has no policy"
          : std::to_string(facts.self_test_rows) + " answers of the policy are as generated";
  const char* const rounding = facts.has_fast_policy ? ", but for rounding (profile fast)" : "";
  return print(stdout, "self-test: " + text + rounding + "; denormal numbers are kept\n")
             ? kDone
             : kBadFile;
}

/// The problem with an agent in another process, or nothing.
std::string problem_of_agent(const Options& options, const GraphProgram& program) {
  if (options.agent != kDdsAgent) return {};
  if (program.is_real() || program.facts().is_split())
    return "error: `--agent dds` cannot drive real hardware: DDS does not authenticate senders\n"
           "help: try the agent in simulation, then give its policy to the graph";
  if (!options.replay.empty() || !options.identify.empty())
    return "error: `--agent dds` does nothing with a log\nhelp: leave it out";
  if (options.real_time_factor > 0.0 && !program.facts().safety.declared)
    return "error: in real time `--agent dds` needs `safety:` in the graph, which says what "
           "becomes "
           "of a late action\nhelp: leave out `--real-time-factor`, and each step waits for its "
           "action";
  return {};
}

/// The problem of options that depend on the graph, or nothing.
std::string problem_of(const Options& options, const Fields& fields, const GraphProgram& program,
                       StateSettings& settings, AgentFaults& faults, Measures& measures) {
  const GraphFacts& facts = program.facts();
  if (options.agent == kExternalAgent) {
    if (program.is_real() && options.real_time_factor != 1.0)
      return "error: real hardware runs in real time only\nhelp: `--real-time-factor 1`";
    if (facts.is_split())
      return "error: " + parts_elsewhere(facts) +
             "\nhelp: an external agent is for a program that is not split";
    if (!options.replay.empty() || !options.identify.empty())
      return "error: a replay has no external agent\nhelp: leave out `--agent`";
    if (!options.faults.empty())
      return "error: an external agent sees observations as they are\nhelp: leave out `--fault`";
  }
  if (options.agent == target::Agent::policy && !facts.has_policy)
    return "error: this program has no policy\nhelp: name a weight file in the graph (`agent: "
           "{policy: FILE}`) or give `--agent zero`, `random` or a file of actions";
  if (facts.is_split() && !options.settings.empty())
    return "error: each part samples its states itself\nhelp: leave out `--set`";
  std::string problem = settings.read(options.settings);
  if (!problem.empty()) return problem;
  problem = problem_of_agent(options, program);
  if (!problem.empty()) return problem;
  if (facts.part_decides && !options.faults.empty())
    return "error: the part with the agent sees and decides itself\nhelp: leave out `--fault`";
  problem = faults.read(options.faults);
  if (!problem.empty()) return problem;
  problem = measures.prepare(options.until, options.measures, options.summary,
                             readables_of(facts, fields.states));
  return problem.empty() ? problem_with_files(options) : problem;
}

/// Everything behind the command line.
int run_with(const Options& given, GraphProgram& program) {
  const GraphFacts& facts = program.facts();
  Options options = given;
  if (const std::string unknown = name_channels(options, facts); !unknown.empty())
    return fail(unknown, kBadUsage);
  const bool is_split = facts.is_split();
  const Fields fields(program);
  StateSettings settings(fields.states);
  AgentFaults faults(fields);
  Measures measures;
  const std::string problem = problem_of(options, fields, program, settings, faults, measures);
  if (!problem.empty()) return fail(problem, kBadUsage);

  std::vector<std::max_align_t> zero(program.action_bytes() / sizeof(std::max_align_t) + 1);
  program.zero(zero.data());
  ActionTable table(fields.actions, zero.data(), program.action_bytes());
  if (options.agent == target::Agent::csv) {
    const ActionProblem bad = table.load(options.action_file, options.plan.steps);
    if (bad.exit_code != 0) return fail(bad.text, bad.exit_code);
  }
  if (!options.replay.empty() || !options.identify.empty()) {
    if (is_split)
      return fail("error: " + parts_elsewhere(facts) +
                      "\nhelp: repeat a log with the program that is not split, which has the same "
                      "messages",
                  kBadUsage);
    return options.replay.empty() ? identify(options, fields, program)
                                  : replay_log(options, fields, table, program);
  }
  if (is_split && !part_knows(facts, options.agent)) {
    return fail("error: the agent is in a part, which knows `zero` and `" +
                    std::string(facts.has_policy ? "policy" : "random") + "`",
                kBadUsage);
  }
  Reconnection reconnection(program, options);
  const std::string unable = reconnection.problem_of_options();
  if (!unable.empty()) return fail(unable, kBadUsage);
  host::catch_interrupts();
  if (is_split) {
    PartLines found;
    const std::string unnamed = find_parts(facts, options, found);
    if (!unnamed.empty()) return fail(unnamed, kBadUsage);
    const std::string unconnected = connect_parts(program, options);
    if (!unconnected.empty()) return fail(unconnected, kBadFile);
  }
  std::optional<RemoteAgent> agent;
  if (options.agent == kDdsAgent)
    agent.emplace(options, facts, fields, zero.data(), program.action_bytes());
  return run_session({options, fields, table, settings, faults, reconnection, measures}, program,
                     agent ? &*agent : nullptr);
}

}  // namespace

int run(int argc, char** argv, GraphProgram& program) {
  open_standard_files();
  bool was_wrong = false;
  if (!put_floats_right(was_wrong))
    return fail("error: this processor flushes denormal numbers", kSelfTestFailed);
  if (was_wrong)
    fail(
        "note: denormal numbers were flushed to zero, or rounding was not to nearest, before this "
        "program began; it has corrected this. The usual cause is `-ffast-math` at link time",
        kDone);
  const GraphFacts& facts = program.facts();
  const std::string other = host::problem_of_graph(host::hex_text(facts.graph_hash));
  if (!other.empty())
    return fail("error: " + other +
                    "\nhelp: something has changed the folder while it was built: run "
                    "the command again",
                kBadFile);
  std::vector<std::uint64_t> out_of_space(facts.channel_count);
  program.spaces.prepare(facts, out_of_space.data());
  program.recorder.graph_is(facts);
  Options defaults;
  defaults.plan = facts.plan;
  defaults.agent = facts.agent;
  defaults.action_file = facts.agent_csv;
  defaults.split = facts.is_split();
  const auto parsed = parse_options(argc - 1, argv + 1, defaults);
  if (const auto* wrong = std::get_if<UsageError>(&parsed))
    return fail("error: " + wrong->problem + "\nhelp: " + wrong->help, kBadUsage);
  Options options = *std::get_if<Options>(&parsed);
  // Somebody looks on, so time goes as it does.
  if (options.rendering.to == "window" && !options.real_time_given) options.real_time_factor = 1.0;
  if (options.help) return show_help(argv[0], defaults, Fields(program), program);
  if (options.version) {
    const std::string text = std::string(facts.name) + " on " + facts.engine + ", eagerx-gen " +
                             std::to_string(kVersionMajor) + "." + std::to_string(kVersionMinor);
    return print(stdout, text + "\n") ? kDone : kBadFile;
  }
  if (!program.rounds_each_operation()) {
    return fail(
        "error: this program was compiled with flags that change the bits of its numbers\n"
        "help: leave out -ffast-math and its parts, and set -ffp-contract=off behind all others",
        kSelfTestFailed);
  }
  return options.self_test ? self_test(program) : run_with(options, program);
}

}  // namespace eagerx::linux_sim
