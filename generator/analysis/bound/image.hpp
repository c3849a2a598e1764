// An image for a board as the analysis of bounds reads it: bytes, symbols, instructions.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "generator/analysis/bound/condition.hpp"

namespace eagerx::gen::bound {

using Address = std::uint32_t;

/// The effect of an instruction on the flow.
enum class Turn : std::uint8_t { none, branch, call, call_pointer, back, table, halt, unknown };

/// The kinds of effects on values.
enum class Kind : std::uint8_t { nothing, supervisor, compare, stack, many, load, store, other };

/// What a known result is made by.
enum class Operation : std::uint8_t {
  unknown,
  mov,
  vmov,
  movt,
  mvn,
  add,
  sub,
  rsb,
  neg,
  lsl,
  lsr,
  bit_and,
  bic,
  orr,
  mul,
  ubfx,
  uxtb,
  uxth,
  cmp
};

/// An operand that is one register or one number.
struct Operand {
  static constexpr std::uint8_t kNoRegister = 0xff;
  std::uint8_t reg = kNoRegister;  // as register_of() counts them
  std::optional<std::int64_t> number;
};

/// [base, #offset], [base, #offset]!, [base], #offset, [base, index, lsl #n]
struct Memory {
  std::size_t base = 0;
  std::int64_t offset = 0, after = 0;
  bool writes_back = false, has_index = false;
  bool is_signed = false, extends_zero = false, is_exclusive = false;
  bool is_double = false;  // a register of the floating-point unit with 64 bits
  bool is_pair = false;    // of two registers
  unsigned width = 4;      // bytes of each
};

/// The registers of "{r4, r5-r7, lr}", or the number of words of "{d8-d11}".
struct RegisterList {
  std::vector<std::uint8_t> registers;
  bool is_of_doubles = false;
  std::uint8_t first = 0, last = 0;  // words of the floating-point unit, of doubles
  std::optional<std::uint8_t> base;  // the address, if it is no stack pointer by itself
  bool writes_back = false, is_down = false, is_load = false;
};

/// One instruction as objdump prints it, without its condition and width, and what that means.
struct Instruction {
  Address at = 0, next = 0;           // of the next one
  std::uint32_t index = 0;            // among all instructions of the image
  std::string name;                   // "mov", "adds", "vldr"
  std::vector<std::string> operands;  // "r0", "[r1, #4]!", "#12", "{r4, pc}"
  Address target = 0;                 // of a branch or call, or of a load from the code
  Condition condition = Condition::always;

  Turn turn = Turn::none;
  Kind kind = Kind::other;
  Operation operation = Operation::unknown;
  bool sets_flags = false;
  std::vector<Operand> values;  // of `operands`
  std::optional<Memory> memory;
  RegisterList list;
  std::vector<std::uint8_t> written;  // registers that it writes, if its result is not known
  bool writes_flags = false;          // to something that is not known, in that case

  [[nodiscard]] bool is_conditional() const { return condition != Condition::always; }
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
  /// By their addresses.
  [[nodiscard]] const std::vector<Instruction>& instructions() const { return code_; }
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
  std::vector<Instruction> code_;
  std::unordered_map<Address, std::uint32_t> index_;  // of instructions
  std::map<Address, std::string> functions_;
  std::multimap<std::string, Address> addresses_;
  std::map<Address, LoopNote> notes_;
};

}  // namespace eagerx::gen::bound
