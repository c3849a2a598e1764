// The main program of target linux-sim, for any generated graph.
#pragma once

#include <cstdio>
#include <cstring>
#include <eagerx/float_environment.hpp>
#include <eagerx/math/rounding_check.hpp>
#include <eagerx/trace.hpp>
#include <eagerx/version.hpp>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <targets/common/run.hpp>
#include <targets/linux-sim/action_file.hpp>
#include <targets/linux-sim/faults.hpp>
#include <targets/linux-sim/files.hpp>
#include <targets/linux-sim/float_environment.hpp>
#include <targets/linux-sim/help.hpp>
#include <targets/linux-sim/identify.hpp>
#include <targets/linux-sim/interrupt.hpp>
#include <targets/linux-sim/options.hpp>
#include <targets/linux-sim/pictures/pictures.hpp>
#include <targets/linux-sim/split.hpp>
#include <targets/linux-sim/state_record.hpp>
#include <targets/linux-sim/state_settings.hpp>
#include <targets/linux-sim/summary.hpp>
#include <targets/linux-sim/text_file.hpp>
#include <targets/linux-sim/trace_file.hpp>
#include <targets/linux-sim/watch.hpp>
#include <variant>

// Called around the stepping of all episodes, if somebody defines them: tests link a guard that
// forbids allocations in between, benchmarks a counter.
extern "C" {
[[gnu::weak]] void eagerx_run_begins();
[[gnu::weak]] void eagerx_run_ends();
}

namespace eagerx::linux_sim {

/// Prints `text` on the standard error and returns `exit_code`.
inline int fail(const std::string& text, int exit_code) {
  std::fputs((text + "\n").c_str(), stderr);
  return exit_code;
}

/// Says that `path` cannot be written and why; returns false.
inline bool cannot_write(const TextFile& file, const std::string& path) {
  const std::string name = path == "-" ? "the standard output" : "`" + path + "`";
  const char* const why = file.error() == ETIMEDOUT ? "nobody reads it, or too slowly"
                          : file.error() == EINVAL  ? "it is no file"
                                                    : std::strerror(file.error());
  fail("error: cannot write " + name + ": " + why, kBadFile);
  return false;
}
/// Written by a thread of its own: a disk that is slow for once must not make a step late.
inline bool open_output(TextFile& file, const std::string& path, Writing writing) {
  return path.empty() || file.open(path, writing) || cannot_write(file, path);
}
inline bool close_output(TextFile& file, const std::string& path) {
  return path.empty() || file.close() || cannot_write(file, path);
}
/// What an earlier run has left stays there until this one has begun well.
inline void keep_earlier_files(TextFile& csv, TextFile& trace) {
  csv.discard();
  trace.discard();
}

/// The agent's action in a step; a file of actions may be shorter than a log.
template <class Graph, class Program>
typename Graph::Action action_of(const Options& options, const ActionTable<Graph>& table,
                                 EpisodeKey key, Seq step,
                                 const typename Graph::Observation& observation, Program& program) {
  if (options.agent != target::Agent::csv)
    return target::act<Graph>(options.agent, key, step, observation, program);
  return step < table.size() ? table[step] : Graph::zero();
}

/// One run of a program whose trace is `Program`'s.
template <class Graph, class Program>
void run_program(const Options& options, const ActionTable<Graph>& table,
                 AgentFaults<Graph>& faults, Program& program, Watch<Graph>& watch) {
  const auto agent = [&](EpisodeKey key, Seq step, const typename Graph::Observation& observation) {
    if constexpr (LinkOf<Graph>::kBoardDecides) {
      // The board has agent and guard, and the program gives back what they did.
      program.link().set_late(watch.late_in_a_row());
      return Graph::zero();
    }
    if (faults.empty()) return action_of<Graph>(options, table, key, step, observation, program);
    return faults.given(
        step, action_of<Graph>(options, table, key, step, faults.seen(step, observation), program));
  };
  target::warm_up(program);  // a library may need memory for it, and none afterwards
  const MadeSafe<Program> made_safe(program);
  if (eagerx_run_begins != nullptr) eagerx_run_begins();
  target::run_episodes<Graph>(options.plan, program, agent, watch);
  const bool ends_early = interrupted() || watch.left_space();
  if constexpr (requires { program.make_safe(); }) {
    // At once: a last step may wait for its instant, or for a board.
    if (ends_early && watch.has_begun() && program.is_real()) program.make_safe();
  }
  if (Graph::kSafety.declared && ends_early && watch.has_begun() && target::is_linked(program)) {
    if constexpr (LinkOf<Graph>::kBoardDecides) program.link().make_safe();
    target::step_safely<Graph>(program);
  }
  if (eagerx_run_ends != nullptr) eagerx_run_ends();
  target::stop(program);
}

/// The agent's action, with what the log gives in its place.
template <class Graph>
typename Graph::Action replayed_action(const trace_log::Replay& replay, std::uint32_t episode,
                                       typename Graph::Action action) {
  Graph::for_each_action(action, [&](const char* name, auto& message, const auto&... /*space*/) {
    const std::string channel = std::string("environment/") + name;
    for (std::uint32_t i = 0; i < std::size(Graph::kChannels); ++i) {
      if (channel == Graph::kChannels[i].name) replay.copy(i, episode, message);
    }
  });
  return action;
}

template <class Graph, class Program>
void replay_episodes(const Options& options, const trace_log::Log& log,
                     const ActionTable<Graph>& table, Program& program, trace_log::Replay& replay) {
  target::warm_up(program);
  for (std::uint32_t episode = 0; episode < log.episodes() && replay.go_on(); ++episode) {
    const EpisodeKey key{log.seed, log.environment, episode};
    program.trace.episode(episode);
    typename Graph::States states = Graph::draw(key);
    repeat_states<Graph>(log, episode, states);
    typename Graph::Observation observation = program.reset(states);
    for (Seq step = 0; replay.go_on() && replay.has_step(episode); ++step) {
      const auto wanted = action_of<Graph>(options, table, key, step, observation, program);
      const auto guarded = target::guarded(program, wanted, 0);  // the log tells no lateness
      const auto action = replayed_action<Graph>(replay, episode, guarded);
      observation = target::apply(program, action);
    }
    replay.end_episode(episode);
  }
}

/// How many steps are done when something ends a run.
inline std::string place_of(const Summary& summary) {
  return "note: the run ended after step " + std::to_string(summary.steps) + " of episode " +
         std::to_string(summary.episodes) + ", counted from 1; files are complete up to there";
}

/// What `--render` wants; empty, or what is wrong.
template <class Graph>
std::string open_pictures(const Options& options) {
  if constexpr (requires { Graph::kRenders; }) {
    return pictures_of_run.open(options.rendering, Graph::kName,
                                text_of_rate<typename Graph::RenderRate>());
  } else if (!options.rendering.to.empty()) {
    return "error: this program has nothing to show\nhelp: write it into the graph, such as "
           "`render: {source: OBJECT.scene}`, and generate the program again";
  }
  return {};
}
/// What is wrong with `--trace-scenes`, or empty.
template <class Graph>
std::string problem_of_scenes(const Options& options) {
  if (!options.trace_scenes || shows_scene<Graph>) return {};
  if constexpr (requires { Graph::kRenders; })
    return "error: what this program shows is pixels, not a scene\nhelp: leave out "
           "`--trace-scenes`; `--render` has the pictures";
  return "error: this program has nothing to show\nhelp: write it into the graph, such as "
         "`render: {source: OBJECT.scene}`, and generate the program again";
}
/// Finishes them, and tells what they were.
template <class Graph>
std::string close_pictures(Summary& summary) {
  if constexpr (requires { Graph::kRenders; }) {
    if (pictures_of_run.is_on()) {
      summary.more.emplace_back("pictures", std::to_string(pictures_of_run.count()));
      std::string hash = hash_line(pictures_of_run.hash());
      hash = hash.substr(hash.find("0x"), 18);
      summary.more.emplace_back("hash of the pictures", hash);
    }
    return pictures_of_run.close();
  } else {
    return static_cast<void>(summary), std::string();
  }
}

/// Runs with everything checked and read; writes files and summary.
template <class Graph>
int run_with(const Options& options, const ActionTable<Graph>& table,
             const StateSettings<Graph>& settings, AgentFaults<Graph>& faults,
             typename LinkOf<Graph>::Type& link) {
  using Recorder = TraceRecorder<Graph>;
  TextFile csv;
  TextFile trace;
  const bool in_real_time =
      options.real_time_factor > 0.0 ||
      target::is_real(target::program_of_run<typename ProgramOf<Graph, Untraced<Graph>>::Type>);
  const Writing writing = in_real_time ? Writing::real_time : Writing::background;
  if (!open_output(csv, options.csv, writing) || !open_output(trace, options.trace, writing))
    return keep_earlier_files(csv, trace), kBadFile;
  if (csv.is_same_file(trace)) {
    keep_earlier_files(csv, trace);
    return fail("error: `--csv` and `--trace` are one file\nhelp: give each its own", kBadUsage);
  }
  std::string unseen = problem_of_scenes<Graph>(options);
  if (unseen.empty()) unseen = open_pictures<Graph>(options);
  if (!unseen.empty()) return keep_earlier_files(csv, trace), fail(unseen, kBadUsage);
  const std::string_view agent = target::name_of(options.agent);

  Watch<Graph> watch(options, settings, csv, trace, link);
  std::uint64_t hash = 0;
  Summary summary;
  summary.graph = Graph::kName;
  summary.engine = Graph::kEngine;
  summary.agent = std::string(agent);
  summary.seed = options.plan.seed;
  if constexpr (requires { Graph::kHasFastPolicy; })
    summary.more.emplace_back("profile", "fast: the hash holds for this build only");
  const auto note = [&](const char* name, std::uint64_t count) {
    summary.faults.emplace_back(name, count);
  };
  const auto note_faults = [&](const auto& program) { target::for_each_fault(program, note); };
  if (options.hash || trace.is_open() || measures_of_run.reads_messages()) {
    auto& program = target::program_of_run<typename ProgramOf<Graph, Recorder>::Type>;
    if constexpr (is_split<Graph>) set_link<Graph>(program, link);
    if (trace.is_open()) {
      Recorder::Text::head(trace, options.plan.seed, options.plan.environment, agent,
                           options.trace_time);
      program.trace.write_to(&trace, options.trace_time);
      if (options.trace_scenes) program.trace.keep_scenes(&trace);
    }
    program.trace.measure();
    run_program(options, table, faults, program, watch);
    if (target::is_linked(program) && calculates_as_everywhere()) program.trace.write_end();
    hash = program.trace.hash();
    note_faults(program);
  } else {
    auto& program = target::program_of_run<typename ProgramOf<Graph, Untraced<Graph>>::Type>;
    if constexpr (is_split<Graph>) set_link<Graph>(program, link);
    run_program(options, table, faults, program, watch);
    note_faults(program);
  }

  spaces_of_run<Graph>.for_each_count([&](const std::string& name, std::uint64_t count) {
    summary.faults.emplace_back(name, count);
  });
  watch.finish(summary);
  const std::string problem_of_pictures = close_pictures<Graph>(summary);
  std::string broken;
  if constexpr (is_split<Graph>) {
    link::Report report;
    link.on_silence(0, nullptr, nullptr);  // the engine has stopped, and its hardware is given back
    if (link.ok())
      link.finish(report, [&](const char* name, std::uint64_t count) {
        note((std::string(name) + " on the board").c_str(), count);
      });
    if (!link.ok()) broken = problem_of<Graph>(link);
    describe_link(summary, Graph::Link::kBoard, link.statistics(), report);
  }
  if (!watch.has_begun()) keep_earlier_files(csv, trace);
  const bool csv_closed = close_output(csv, options.csv);
  const bool trace_closed = close_output(trace, options.trace);
  const bool is_right = calculates_as_everywhere();
  std::FILE* const out = options.csv == "-" || options.trace == "-" ? stderr : stdout;
  std::string text = options.quiet ? "" : summary_text(summary);
  if (options.hash && broken.empty() && is_right) text += hash_line(hash);
  const bool printed = text.empty() || print(out, text);
  if (!broken.empty()) fail(broken + "\n" + place_of(summary), kBadFile);
  if (!problem_of_pictures.empty()) fail(problem_of_pictures, kBadFile);
  if (!is_right) fail(kFloatsWentWrong, kSelfTestFailed);
  if (watch.left_space())
    fail("error: " + spaces_of_run<Graph>.first() + "\n" + place_of(summary), kLeftSpace);
  const std::string not_finite = watch.not_finite();
  if (!not_finite.empty()) fail(not_finite, kNotFinite);
  end_as_told();
  if (!broken.empty()) return kBadFile;
  if (!is_right) return kSelfTestFailed;
  if (!not_finite.empty()) return kNotFinite;
  if (watch.left_space()) return kLeftSpace;
  if (!problem_of_pictures.empty()) return kBadFile;
  return csv_closed && trace_closed && printed ? kDone : kBadFile;
}

/// Repeats the run of a log: exit code 0 if nothing differs, 1 if something does.
template <class Graph>
int replay_log(const Options& options, const ActionTable<Graph>& table) {
  std::string problem;
  const std::optional<trace_log::Log> log = trace_log::read_log_file(options.replay, problem);
  if (!log) return fail(problem, kBadFile);
  auto& program = target::program_of_run<typename Graph::template Program<TraceRecorder<Graph>>>;
  trace_log::Replay replay(*log, Graph::kChannels);
  if (!replay.prepare(options.replay_given, target::is_real(program), problem))
    return fail(problem, kBadFile);
  program.trace.follow(&replay);
  replay_episodes<Graph>(options, *log, table, program, replay);
  std::string text = replay.report(Graph::kName, Graph::kEngine);
  if (options.hash) text += hash_line(program.trace.hash());
  if (!print(stdout, text)) return kBadFile;
  return replay.divergence() ? kDiverged : kDone;
}

/// Finds parameters and delays of the run of a log.
template <class Graph>
int identify(const Options& options) {
  std::string problem;
  const std::optional<trace_log::Log> log = trace_log::read_log_file(options.identify, problem);
  if (!log) return fail(problem, kBadFile);
  auto& program = target::program_of_run<typename Graph::template Program<TraceRecorder<Graph>>>;
  const trace_log::Replay same(*log, Graph::kChannels);
  if (!same.fits(problem)) return fail(problem, kBadFile);
  if (target::is_real(program) || requires { program.reset_timeouts(); }) {
    return fail(
        "error: parameters are identified in the program of a simulation without reset nodes\n"
        "help: generate the graph for OdeEngine, with `--engine OdeEngine`",
        kBadUsage);
  }
  target::warm_up(program);
  const int code = identify_with<Graph>(options, *log, program, problem);
  return problem.empty() ? code : fail(problem, code);
}

/// Compares the policy's answers with those that the generator computed.
template <class Graph>
int self_test() {
  if (!Graph::policies_answer()) {
    return fail(
        "error: this machine's answers of the policy differ from the generator's\n"
        "help: build with the flags of the runtime: no fast-math, no contraction",
        kSelfTestFailed);
  }
  const std::string text =
      Graph::kSelfTestRows == 0
          ? "this program has no policy"
          : std::to_string(Graph::kSelfTestRows) + " answers of the policy are as generated";
  const char* const rounding = requires {
    Graph::kHasFastPolicy;
  }
  ? ", but for rounding (profile fast)" : "";
  return print(stdout, "self-test: " + text + rounding + "; denormal numbers are kept\n")
             ? kDone
             : kBadFile;
}

/// The main function: reads the command line, runs, returns the exit code (see --help).
template <class Graph>
int run(int argc, char** argv) {
  open_standard_files();
  bool was_wrong = false;
  if (!put_floats_right(was_wrong))
    return fail("error: this processor does not keep denormal numbers", kSelfTestFailed);
  if (was_wrong)
    fail(
        "note: denormal numbers were taken for zero, or numbers rounded otherwise, before this "
        "program began; it has put that right. Usually it is linked with `-ffast-math`",
        kDone);
  Options defaults;
  defaults.plan = target::default_plan<Graph>();
  defaults.agent = target::default_agent<Graph>();
  defaults.action_file = Graph::kAgentCsv;
  defaults.split = is_split<Graph>;
  const auto parsed = parse_options(argc - 1, argv + 1, defaults);
  if (const auto* wrong = std::get_if<UsageError>(&parsed)) {
    return fail("error: " + wrong->problem + "\nhelp: " + wrong->help, kBadUsage);
  }
  Options options = *std::get_if<Options>(&parsed);
  // Somebody looks on, so time goes as it does.
  if (options.rendering.to == "window" && !options.real_time_given) options.real_time_factor = 1.0;
  if (options.help) return show_help<Graph>(argv[0], defaults);
  if (options.version) {
    const std::string text = std::string(Graph::kName) + " on " + Graph::kEngine + ", eagerx-gen " +
                             std::to_string(kVersionMajor) + "." + std::to_string(kVersionMinor);
    return print(stdout, text + "\n") ? kDone : kBadFile;
  }
  if (!rounds_each_operation()) {
    return fail(
        "error: this program was compiled with flags that change the bits of its numbers\n"
        "help: leave out -ffast-math and its parts, and set -ffp-contract=off behind all others",
        kSelfTestFailed);
  }
  if (options.self_test) return self_test<Graph>();
  if (options.agent == target::Agent::policy && !Graph::kHasPolicy) {
    return fail(
        "error: this program has no policy\nhelp: name a weight file in the graph (`agent: "
        "{policy: FILE}`) or give `--agent zero`, `random` or a file of actions",
        kBadUsage);
  }
  StateSettings<Graph> settings;
  const std::string problem_of_settings =
      is_split<Graph> && !options.settings.empty()
          ? "error: the board draws its states itself\nhelp: leave out `--set`"
          : settings.read(options.settings);
  if (!problem_of_settings.empty()) return fail(problem_of_settings, kBadUsage);
  AgentFaults<Graph> faults;
  const std::string problem_of_faults =
      LinkOf<Graph>::kBoardDecides && !options.faults.empty()
          ? "error: the board sees and decides itself\nhelp: leave out `--fault`"
          : faults.read(options.faults);
  if (!problem_of_faults.empty()) return fail(problem_of_faults, kBadUsage);
  const std::string problem_of_measures = measures_of_run.prepare(
      options.until, options.measures, options.summary, readables_of<Graph>());
  if (!problem_of_measures.empty()) return fail(problem_of_measures, kBadUsage);
  const std::string problem_of_files = problem_with_files(options);
  if (!problem_of_files.empty()) return fail(problem_of_files, kBadUsage);

  ActionTable<Graph> table;
  if (options.agent == target::Agent::csv) {
    const ActionProblem problem = table.load(options.action_file, options.plan.steps);
    if (problem.exit_code != 0) return fail(problem.text, problem.exit_code);
  }
  if (!options.replay.empty() || !options.identify.empty()) {
    if constexpr (is_split<Graph>) {
      return fail("error: a part of this graph runs on " + std::string(Graph::Link::kBoard) +
                      "\nhelp: repeat a log with the program that is not split, which has the same "
                      "messages",
                  kBadUsage);
    } else {
      return options.replay.empty() ? identify<Graph>(options) : replay_log<Graph>(options, table);
    }
  }
  if (!board_knows<Graph>(options.agent)) {
    return fail("error: the agent is on the board, which knows `zero` and `" +
                    std::string(Graph::kHasPolicy ? "policy" : "random") + "`",
                kBadUsage);
  }
  catch_interrupts();
  typename LinkOf<Graph>::Type link{};
  if constexpr (is_split<Graph>) {
    if (options.link.empty()) {
      return fail("error: a part of this graph runs on " + std::string(Graph::Link::kBoard) +
                      "\nhelp: say where that is, `--link` with a serial line, HOST:PORT or "
                      "unix:PATH",
                  kBadUsage);
    }
    const std::string problem = connect<Graph>(link, options);
    if (!problem.empty()) return fail(problem, kBadFile);
  }
  return run_with<Graph>(options, table, settings, faults, link);
}

}  // namespace eagerx::linux_sim
