// --help of a program: what its graph is, and the options.
#pragma once

#include <cstdio>
#include <string>
#include <targets/common/run.hpp>
#include <targets/linux-sim/describe.hpp>
#include <targets/linux-sim/files.hpp>
#include <targets/linux-sim/options.hpp>
#include <targets/linux-sim/split.hpp>
#include <targets/linux-sim/trace_file.hpp>

namespace eagerx::linux_sim {

template <class Graph>
int show_help(const char* program_name, const Options& defaults) {
  using Recorder = TraceRecorder<Graph>;
  auto& program = target::program_of_run<typename ProgramOf<Graph, Recorder, link::NoLink>::Type>;
  link::NoLink none;
  if constexpr (is_split<Graph>) program.connect(none);
  // Somebody who asks for help does not want a robot to move.
  if (target::is_real(program)) program.trace.leave_engine_alone();
  std::string text = "Usage: " + std::string(program_name) + " [OPTION…]\n" +
                     (target::is_real(program) ? "Runs" : "Simulates") + " the graph `" +
                     Graph::kName + "` on " + Graph::kEngine + " at " +
                     number_text(Graph::Rate::hz) + " Hz.\n\n";
  text += describe<Graph>(program.reset(Graph::draw(EpisodeKey{defaults.plan.seed, 0, 0})));
  text += "Options (defaults in brackets):\n" + options_help(defaults);
  return print(stdout, text) ? kDone : kBadFile;
}

}  // namespace eagerx::linux_sim
