// Where the instructions of an image come from: functions, lines, nodes of the graph.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "generator/analysis/bound/image.hpp"
#include "generator/backend/program_map/program_map.hpp"

namespace eagerx::gen::bound {

/// Texts that many frames share, by their numbers.
class Texts {
 public:
  std::uint32_t number_of(std::string_view text);
  [[nodiscard]] const std::vector<std::string>& all() const { return all_; }

 private:
  struct Hash : std::hash<std::string_view> {
    using is_transparent = void;
  };
  std::vector<std::string> all_;
  std::unordered_map<std::string, std::uint32_t, Hash, std::equal_to<>> numbers_;
};

/// A function, and the line in it that an instruction, or what is inlined there, comes from.
struct Frame {
  std::uint32_t function = 0;  // of Places::functions()
  std::uint32_t file = 0;      // of Places::files()
  std::uint32_t line = 0;
};

class Places {
 public:
  /// Asks the compiler's addr2line for every instruction.
  explicit Places(const Image& image);

  /// From the innermost function that is inlined there to the one that has the instruction.
  [[nodiscard]] const std::vector<Frame>& of(const Instruction& instruction) const {
    return frames_[instruction.index];
  }
  /// [functions()] where each is: instructions, with the frame that is of it, in order.
  struct Occurrence {
    std::uint32_t instruction = 0, frame = 0;
    auto operator<=>(const Occurrence&) const = default;
  };
  [[nodiscard]] const std::vector<std::vector<Occurrence>>& occurrences() const {
    return occurrences_;
  }
  /// Mangled names.
  [[nodiscard]] const std::vector<std::string>& functions() const { return functions_.all(); }
  [[nodiscard]] const std::vector<std::string>& files() const { return files_.all(); }
  /// The path of the program.hpp that the image was made of; empty: none.
  [[nodiscard]] std::string program() const;
  /// [instructions] the node whose lines of program.hpp each comes from; nullptr: none.
  [[nodiscard]] std::vector<const std::string*> nodes(const ProgramMap& map) const;

 private:
  /// [files()] whether a file is the program.hpp.
  [[nodiscard]] std::vector<bool> are_programs() const;

  Texts functions_, files_;
  std::vector<std::vector<Frame>> frames_;  // [instructions]
  std::vector<std::vector<Occurrence>> occurrences_;
};

}  // namespace eagerx::gen::bound
