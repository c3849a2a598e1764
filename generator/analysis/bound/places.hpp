// Where the instructions of an image come from: functions, lines, nodes of the graph.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "generator/analysis/bound/image.hpp"
#include "generator/backend/program_map/program_map.hpp"

namespace eagerx::gen::bound {

/// A function, and the line in it that an instruction, or what is inlined there, comes from.
struct Frame {
  std::string function;  // mangled
  std::string file;
  std::uint32_t line = 0;
};

class Places {
 public:
  /// Asks the compiler's addr2line for every instruction.
  explicit Places(const Image& image);

  /// From the innermost function that is inlined there to the one that has the instruction.
  [[nodiscard]] const std::vector<Frame>& of(Address at) const;
  /// The path of the program.hpp that the image was made of; empty: none.
  [[nodiscard]] std::string program() const;
  /// The node whose lines of program.hpp an instruction comes from; nullptr: none.
  [[nodiscard]] const std::string* node(Address at, const ProgramMap& map) const;

 private:
  std::map<Address, std::vector<Frame>> frames_;
};

}  // namespace eagerx::gen::bound
