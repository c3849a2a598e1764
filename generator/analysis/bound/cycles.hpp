// The most cycles that instructions take on cores whose timing Arm publishes.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "generator/analysis/bound/cost.hpp"

namespace eagerx::gen::bound {

enum class Core : std::uint8_t { cortex_m3, cortex_m4 };

/// By the name of a core in a board's manifest: `Cortex-M3`, `Cortex-M4`, `Cortex-M4F`. nullopt:
/// its timing depends on caches or several issues a cycle, or is not published.
std::optional<Core> core_of(std::string_view cpu);

/// Cycles by Arm's tables: Cortex-M3 TRM (DDI 0337I) 3.3.1, Cortex-M4 TRM (DDI 0439B) 3.3.1 and
/// 7.2.3, each at its longest. An instruction that is not in these tables counts as the slowest.
/// Every word of code that a block enters costs the wait states of the flash, and so does every
/// word that is read but for those of the stack; a fetch that a jump makes useless costs them, too.
class Cycles : public Cost {
 public:
  Cycles(const Image& image, Core core, unsigned wait_states);

  [[nodiscard]] std::uint64_t of(const Instruction& instruction,
                                 const Instruction* before) const override;
  [[nodiscard]] std::uint64_t taken(const Instruction& jump) const override;
  /// The exception around a handler of `most` cycles: stacking, its vector, returning and filling
  /// the pipeline again. `saves_floats`: the handler uses the floating-point unit.
  [[nodiscard]] std::uint64_t exception(std::uint64_t most, bool saves_floats) const;

 private:
  [[nodiscard]] std::uint64_t integer(const Instruction& instruction) const;
  [[nodiscard]] std::uint64_t floating(const Instruction& instruction) const;
  [[nodiscard]] std::uint64_t refill() const;
  [[nodiscard]] std::uint64_t without_fetch(const Instruction& instruction) const;

  const Image& image_;
  Core core_;
  unsigned wait_states_;
  std::vector<std::uint64_t> without_fetch_;  // [instructions]
};

}  // namespace eagerx::gen::bound
