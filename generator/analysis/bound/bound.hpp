// The largest number of instructions, and of cycles, that each part of a program can take, from its
// image alone.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/analysis/bound/machine.hpp"
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
  std::uint64_t cycles = 0;  // only with BoundReport::time
  bool is_bound = true;      // false: `most` leaves out what NoBound names
};

/// Of a kind of slot.
struct SlotBound : InstructionBound {
  struct Half {
    std::uint64_t most = 0, cycles = 0;
  };
  std::optional<std::uint64_t> due;          // its rates, as bits; nullopt: any
  Half before = {}, after = {};              // the environment's action
  std::vector<InstructionBound> nodes = {};  // in this slot
};

/// An interrupt of the board.
struct InterruptBound {
  std::string handler;
  std::uint64_t cycles = 0;  // with entry and return
  double most_hz = 0;
};

/// What cycles are counted for.
struct TimeModel {
  std::string board, cpu;
  std::uint64_t clock_hz = 0;
  std::optional<unsigned> wait_states;
  std::vector<InterruptBound> interrupts;

  /// The longest time of work of this many cycles, with the interrupts that may come meanwhile;
  /// infinite where these take all of the time.
  [[nodiscard]] double seconds(std::uint64_t cycles) const;
};

/// A function of the image, whatever its arguments are.
struct FunctionBound {
  std::string name;
  std::uint64_t address = 0, most = 0;
};

struct BoundReport {
  std::vector<InstructionBound> parts;   // step, reset, guard, policy: those that the image has
  std::vector<SlotBound> slots;          // each kind of slot, by the rates that are due
  std::vector<InstructionBound> nodes;   // in a step
  std::vector<FunctionBound> functions;  // that have a bound; for comparisons with what is executed
  std::vector<NoBound> missing;
  std::optional<TimeModel> time;
  std::string why_no_time;  // "no cycles are known of a Cortex-M7"; empty: there are some

  /// nullptr: the image has no such part.
  [[nodiscard]] const InstructionBound* part(std::string_view name) const;
};

/// `rates`: names of the graph's rates in the order of the bits of its slots; empty: bits are
/// printed. `machine`: the board, for cycles; nullptr: not known. Problems: E0911 for an image that
/// cannot be analysed, E0427 for what has no bound.
std::optional<BoundReport> bound_instructions(const std::string& image,
                                              const std::vector<std::string>& rates,
                                              const Machine* machine, Diagnostics& diagnostics);

/// A part of the table, as in bound_text(), and a row as in bound_json().
std::string bound_rows_text(const char* title, const std::vector<InstructionBound>& rows,
                            const std::optional<TimeModel>& time);
Json bound_row_json(const InstructionBound& row, const std::optional<TimeModel>& time);

std::string bound_text(const BoundReport& report);
/// `with_functions`: with the bound of each function of the image, for comparisons.
Json bound_json(const BoundReport& report, bool with_functions = true);
/// Whether cycles of this board are known.
bool has_cycles(const Machine& machine);

}  // namespace eagerx::gen
