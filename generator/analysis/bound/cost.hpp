// What an instruction counts: one, or its cycles.
#pragma once

#include <cstdint>

#include "generator/analysis/bound/image.hpp"

namespace eagerx::gen::bound {

class Cost {
 public:
  Cost() = default;
  virtual ~Cost() = default;
  Cost(const Cost&) = delete;
  Cost& operator=(const Cost&) = delete;

  /// `before`: the instruction of the same block that comes before it; nullptr: none.
  [[nodiscard]] virtual std::uint64_t of(const Instruction& instruction,
                                         const Instruction* before) const = 0;
  /// What comes on top where the jump at the end of a block is taken.
  [[nodiscard]] virtual std::uint64_t taken(const Instruction& jump) const = 0;
};

/// 1 for each instruction.
const Cost& instruction_cost();

}  // namespace eagerx::gen::bound
