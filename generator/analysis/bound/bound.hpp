// The largest number of instructions that each part of a program can take, from its image alone.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "generator/support/diagnostics/diagnostics.hpp"
#include "generator/support/json/json.hpp"

namespace eagerx::gen {

/// Why something has no bound.
struct NoBound {
  std::string what;   // "the loop", "the call through a pointer"
  std::string place;  // "models/nodes/x/x.hpp:12"
  std::string function;
  std::string help;
  std::vector<std::string> of;  // the parts and nodes without a bound
};

struct InstructionBound {
  std::string name;
  std::uint64_t most = 0;
  bool is_bound = true;  // false: `most` leaves out what NoBound names
};

/// A function of the image, whatever its arguments are.
struct FunctionBound {
  std::string name;
  std::uint64_t address = 0, most = 0;
};

struct BoundReport {
  std::vector<InstructionBound> parts;   // step, reset, guard, policy: those that the image has
  std::vector<InstructionBound> slots;   // each kind of slot, by the rates that are due
  std::vector<InstructionBound> nodes;   // in a step
  std::vector<FunctionBound> functions;  // that have a bound; for comparisons with what is executed
  std::vector<NoBound> missing;
};

/// `rates`: names of the graph's rates in the order of the bits of its slots; empty: bits are
/// printed. Problems: E0911 for an image that cannot be analysed, E0427 for what has no bound.
std::optional<BoundReport> bound_instructions(const std::string& image,
                                              const std::vector<std::string>& rates,
                                              Diagnostics& diagnostics);

std::string bound_text(const BoundReport& report);
Json bound_json(const BoundReport& report);

}  // namespace eagerx::gen
