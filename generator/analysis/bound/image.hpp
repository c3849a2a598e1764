// An image for a board as the analysis of bounds reads it: bytes, symbols, instructions.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace eagerx::gen::bound {

using Address = std::uint32_t;

/// One instruction as objdump prints it, without its condition and width.
struct Instruction {
  Address at = 0, next = 0;           // of the next one
  std::string name;                   // "mov", "adds", "vldr"
  std::string condition;              // "eq"; empty: always
  std::vector<std::string> operands;  // "r0", "[r1, #4]!", "#12", "{r4, pc}"
  Address target = 0;                 // of a branch or call, or of a load from the code
};

/// The bound that a loop's source states, in a section of notes (runtime/eagerx/bounded.hpp).
struct LoopNote {
  std::uint32_t most = 0;  // how often it is passed, for each time that its loop is entered
  bool waits = false;      // the loop waits for a time or a device
};

class Image {
 public:
  /// Reads an image for Arm's M profile with the tools called `prefix`objdump and `prefix`nm.
  /// nullopt: one of them, or the file, cannot be read.
  static std::optional<Image> read(const std::string& path, const std::string& prefix);

  /// nullptr: there is no instruction at this address.
  [[nodiscard]] const Instruction* instruction(Address at) const;
  /// `size` bytes (1, 2 or 4) of memory that no instruction writes, little-endian.
  [[nodiscard]] std::optional<std::uint32_t> constant(Address at, unsigned size) const;
  [[nodiscard]] const std::map<Address, Instruction>& instructions() const { return code_; }
  /// Names of functions (mangled), by their addresses; of several names the first.
  [[nodiscard]] const std::map<Address, std::string>& functions() const { return functions_; }
  /// The same by name, all of them.
  [[nodiscard]] const std::multimap<std::string, Address>& addresses() const { return addresses_; }
  /// The function that this address lies in; empty: none.
  [[nodiscard]] std::string function_of(Address at) const;
  [[nodiscard]] const std::map<Address, LoopNote>& notes() const { return notes_; }
  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] const std::string& prefix() const { return prefix_; }

 private:
  struct Segment {
    Address begin = 0;
    std::string bytes;
  };
  bool read_segments();
  void read_notes(const std::string& file);
  bool read_code();
  bool read_functions();

  std::string path_, prefix_;
  std::vector<Segment> constants_;
  std::map<Address, Instruction> code_;
  std::map<Address, std::string> functions_;
  std::multimap<std::string, Address> addresses_;
  std::map<Address, LoopNote> notes_;
};

}  // namespace eagerx::gen::bound
