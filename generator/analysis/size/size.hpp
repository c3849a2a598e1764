// Resources of an image for a board: flash and RAM of each node, stack, instructions.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "generator/support/diagnostics/diagnostics.hpp"
#include "generator/support/json/json.hpp"

namespace eagerx::gen {

struct Usage {
  std::uint64_t flash = 0, ram = 0;
};

/// A function on the deepest chain of calls.
struct StackCall {
  std::string function;  // "Program::run_slot"
  std::string part;      // whose it is: `pendulum/theta`, or one of SizeReport::others
  bool of_node = false;
  std::uint64_t bytes = 0;                   // its own
  std::uint64_t begin = 0, called_from = 0;  // addresses; the first has no caller: both the same
};

/// The deepest chain of calls.
struct StackBound {
  std::uint64_t bytes = 0;
  std::vector<std::string> path;       // mangled names, from the start
  std::vector<std::string> unbounded;  // functions that call through pointers, or themselves
  std::vector<StackCall> calls;        // the path again
};

/// Instructions of the slots of a run, counted by the emulator, the agent and the measurement
/// included. Not a bound.
struct Instructions {
  std::uint64_t slots = 0, least = 0, most = 0;
  double mean = 0.0;
};

struct SizeReport {
  std::uint64_t flash = 0, ram = 0;     // of the image, the stack not included
  std::map<std::string, Usage> nodes;   // by the graph's names; `pendulum/theta` is an engine node
  std::map<std::string, Usage> others;  // policy, schedule, rings, runtime, board, libraries, other
  StackBound stack;
  std::optional<Instructions> instructions;
};

/// Reads an image that was compiled with -g. `build` is the folder with the compiler's .ci files
/// (-fcallgraph-info=su). Flash: every address belongs to the block of program.hpp that it was
/// inlined into, or to its own source. RAM: the members of the program object. Problems: E0911.
std::optional<SizeReport> measure_image(const std::string& image, const std::string& build,
                                        Diagnostics& diagnostics);

/// The chain of calls, a line for each: bytes, whose it is, function.
std::string stack_text(const StackBound& stack);
std::string size_text(const SizeReport& report);
Json size_json(const SizeReport& report);

}  // namespace eagerx::gen
