// --help of a program: what its graph is, and the options.
#pragma once

#include <cstdio>
#include <eagerx/trace.hpp>
#include <string>
#include <targets/common/run.hpp>
#include <targets/linux-sim/describe.hpp>
#include <targets/linux-sim/files.hpp>
#include <targets/linux-sim/options.hpp>
#include <targets/linux-sim/split.hpp>

namespace eagerx::linux_sim {

/// Somebody who asks for help does not want a robot to move: engines that act on the world
/// themselves are neither started nor called.
struct HelpTrace : NoTrace {
  bool is_real = false;
  bool runs_engine() const { return !is_real; }
};

template <class Graph>
int show_help(const char* program_name, const Options& defaults) {
  auto& program = target::program_of_run<typename ProgramOf<Graph, HelpTrace, link::NoLink>::Type>;
  link::NoLink none;
  if constexpr (is_split<Graph>) program.link = &none;
  program.trace.is_real = target::is_real(program);
  std::string text = "Usage: " + std::string(program_name) + " [OPTION…]\n" +
                     (target::is_real(program) ? "Runs" : "Simulates") + " the graph `" +
                     Graph::kName + "` on " + Graph::kEngine + " at " +
                     number_text(Graph::Rate::hz) + " Hz.\n\n";
  text += describe<Graph>(program.reset(Graph::draw(EpisodeKey{defaults.plan.seed, 0, 0})));
  text += "Options (defaults in brackets):\n" + options_help(defaults);
  return print(stdout, text) ? kDone : kBadFile;
}

}  // namespace eagerx::linux_sim
