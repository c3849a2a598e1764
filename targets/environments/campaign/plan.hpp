// Runs of a campaign: its results depend on a plan and a library, and on nothing else.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "targets/common/fault.hpp"
#include "targets/environments/client/description.hpp"

namespace eagerx::campaign {

/// `--vary NAME=LOW:HIGH`: a state or a delay, or one of its elements (`NAME[i]`).
struct Variation {
  std::string name;
  double low = 0.0, high = 0.0;
};

/// Runs in a chunk, which one thread computes, and which is written to the checkpoint as a whole.
/// Constant, because results must not depend on the number of threads.
inline constexpr std::uint32_t kChunk = 256;

/// Steps of an episode that the task does not end, as in programs for Linux.
inline constexpr std::uint32_t kDefaultSteps = 300;

/// A number of the states that each run samples for itself.
struct Sampled {
  std::size_t column = 0;  // in a row of states
  std::string stream;      // what its random numbers are called
  bool is_real = true;     // else a whole number
  double low = 0.0, high = 0.0;
};

/// The rows in which faults are.
enum class FaultRow : std::uint8_t { observation, action };

struct Plan {
  std::uint64_t seed = 1;
  std::uint32_t runs = 0;
  std::uint32_t longest = 0;  // steps
  std::vector<Variation> variations;
  std::vector<Sampled> sampled;
  std::vector<std::string> columns;         // names of the numbers of the states
  std::vector<target::PlacedFault> faults;  // of numbers of rows: `place` is a FaultRow

  std::uint32_t chunks() const { return (runs + kChunk - 1) / kChunk; }
  std::uint32_t first_of(std::uint32_t chunk) const { return chunk * kChunk; }
  std::uint32_t size_of(std::uint32_t chunk) const {
    return runs - first_of(chunk) < kChunk ? runs - first_of(chunk) : kChunk;
  }
  /// States of a run, [columns]: a function of (seed, run, name). NaN: sampled as the graph says.
  std::vector<float> states_of(std::uint32_t run) const;
  /// Faults of a run with the steps at which they begin: a function of (seed, run, fault).
  std::vector<target::PlacedFault> faults_of(std::uint32_t run) const;
  /// Numbers that are kept of a run: states, then a step for each fault.
  std::size_t width() const { return columns.size() + faults.size(); }
  /// The name of such a number.
  std::string name_of(std::size_t number) const;
};

/// `angle=silent+5`, with @ and a step if that is the same for all runs.
std::string text_of(const target::Fault& fault);

/// `steps`: 0 for those of the task. Throws Problem if the graph does not define success, or for
/// elements that cannot be varied or have a fault.
Plan make_plan(const client::Description& description, std::uint64_t seed, std::uint32_t runs,
               std::uint32_t steps, std::vector<Variation> variations,
               std::vector<target::Fault> faults);

}  // namespace eagerx::campaign
