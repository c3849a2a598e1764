// Results of instructions that calculate, from what is known of their operands.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

#include "generator/analysis/bound/value.hpp"

namespace eagerx::gen::bound {

class Calculation {
 public:
  Calculation(const Instruction& instruction, const State& state, Sums& sums)
      : instruction_(instruction), state_(state), sums_(sums) {}

  [[nodiscard]] std::string_view operand(std::size_t i) const;
  /// As State::registers has it; nullopt: the operand is no register.
  [[nodiscard]] std::optional<std::size_t> register_at(std::size_t i) const;
  [[nodiscard]] std::optional<std::int64_t> number_at(std::size_t i) const;
  /// The value of a register or number; nullopt: it is neither, or the program counter.
  [[nodiscard]] std::optional<Value> read(std::size_t i) const;
  /// What is calculated with: `subs r0, #1` has r0 and 1.
  [[nodiscard]] std::pair<std::optional<Value>, std::optional<Value>> two_operands() const;
  /// A number of its own with these bits, in the first operand.
  [[nodiscard]] std::optional<Value> of_bits(unsigned bits) const;
  /// False: not an operation that is known. An empty value: its result is not known.
  bool result(std::optional<Value>& value) const;

 private:
  using Known = std::optional<Value>;

  [[nodiscard]] Known shifted(std::size_t i) const;
  [[nodiscard]] Known scaled(const Value& unscaled, std::optional<std::int64_t> shift) const;
  [[nodiscard]] Known total(const Known& a, const Known& b, int sign) const;
  [[nodiscard]] Known shifted_right(const Known& left, const Known& right) const;
  [[nodiscard]] Known extended(const Known& right, unsigned width) const;
  bool shift(Known& value) const;
  bool bits(Operation operation, const Known& left, const Known& right, Known& value) const;

  const Instruction& instruction_;
  const State& state_;
  Sums& sums_;
};

}  // namespace eagerx::gen::bound
