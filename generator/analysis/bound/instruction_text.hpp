// Lines of objdump as instructions of Arm's M profile.
#pragma once

#include <optional>
#include <string_view>

#include "generator/analysis/bound/image.hpp"

namespace eagerx::gen::bound {

/// Reads a disassembly (-d --no-show-raw-insn) line by line; knows which instructions depend on an
/// `it` before them.
class InstructionReader {
 public:
  /// The instruction of this line; nullopt: it has none, or data.
  std::optional<Instruction> line(std::string_view text);
  /// The address of the data in the line before; nullopt: there was none.
  [[nodiscard]] std::optional<Address> data() const { return data_; }

 private:
  void condition(Instruction& instruction);

  std::optional<Address> data_;
  unsigned conditional_ = 0;  // of the next instructions
};

}  // namespace eagerx::gen::bound
