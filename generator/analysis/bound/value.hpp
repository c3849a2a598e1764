// What is known of registers and of the stack at a point of a function.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "generator/analysis/bound/flat_map.hpp"
#include "generator/analysis/bound/image.hpp"

namespace eagerx::gen::bound {

/// A number that is not known, by the place that gave it; 0: the number 0.
using Base = std::uint64_t;
inline constexpr Base kStack = 1;  // the stack pointer at the function's entry

/// base + something from low to high.
struct Value {
  Base base = 0;
  std::int64_t low = 0, high = 0;

  static Value of(std::int64_t number) { return {0, number, number}; }
  [[nodiscard]] bool is_exact() const { return low == high; }
  [[nodiscard]] bool is_number() const { return base == 0 && low == high; }
  bool operator==(const Value&) const = default;
};

inline constexpr std::size_t kRegisters = 48;  // r0 to r15, then s0 to s31
inline constexpr std::size_t kCore = 16;       // r0 to r15
inline constexpr std::size_t kSp = 13;
inline constexpr std::int64_t kWordBytes = 4;

/// Where a value is: a register, or a word of the stack by its distance from kStack.
struct Location {
  bool on_stack = false;
  std::int64_t at = 0;
  auto operator<=>(const Location&) const = default;
};

/// Operands of the last comparison; empty: not known. With `zero_only`, a difference whose overflow
/// and carry are not known.
struct Comparison {
  Value left, right;
  bool zero_only = false;
  bool operator==(const Comparison&) const = default;
};

/// A register that has this value if a condition of the flags, as they are, holds.
struct Choice {
  std::size_t at = 0;
  Condition condition = Condition::always;
  Value value;
};

/// What numbers that are not known are between.
using Limits = FlatMap<Base, Value>;

struct State {
  std::array<Value, kRegisters> registers{};
  FlatMap<std::int64_t, Value> stack;
  std::optional<Comparison> comparison;
  std::optional<Choice> choice;      // the last one
  std::int64_t escaped = INT64_MAX;  // from here on other pointers may lead to the stack
  bool arguments_escaped = false;    // and to the words that the caller has put there
  Limits limits;

  [[nodiscard]] const Value* find(const Location& location) const;
  /// Registers, and the words of the stack that are known.
  [[nodiscard]] std::vector<Location> locations() const;
  void set(const Location& location, const Value& value);
  /// A number by what is known of its base, and of the base of that. Else the value itself.
  [[nodiscard]] Value resolve(const Value& value) const;
  /// The same until both have one base; false if they have none.
  bool relate(Value& a, Value& b) const;
  /// The base that a condition says something of, and what it is between then.
  [[nodiscard]] std::optional<std::pair<Base, Value>> learned(Condition condition,
                                                              const Comparison& compared) const;
  /// Adds the consequences of a condition that holds.
  void learn(Condition condition, const Comparison& compared);

 private:
  [[nodiscard]] std::optional<std::pair<Base, Value>> not_at_end(const Value& left,
                                                                 const Value& right) const;
};

/// a + sign * b, if the sum has one base.
std::optional<Value> sum(const Value& a, const Value& b, int sign);

/// The number that is made at an address, or that two paths bring to it; a sum of several.
enum class Origin : std::uint8_t { made, joined, header, entry, sum };
// The bits of a base: what made it, of how many bits it is, half its address, its location.
inline constexpr unsigned kIsPlace = 63, kOrigin = 60, kBits = 55, kAddress = 24;
constexpr Base base_of(Origin origin, Address at, const Location& location) {
  constexpr std::uint64_t kOffset = 0x7fffff, kOfStack = 0x800000;
  const auto where = static_cast<std::uint64_t>(location.at) & kOffset;
  return (std::uint64_t{1} << kIsPlace) | (static_cast<std::uint64_t>(origin) << kOrigin) |
         (std::uint64_t{at >> 1U} << kAddress) | where | (location.on_stack ? kOfStack : 0);
}
/// The same of a number from 0 to 2^bits - 1; `bits` up to 31.
Base base_of_bits(Address at, const Location& location, unsigned bits);
/// Whether a value is an unknown number plus one of several, and not that of a loop's header or the
/// stack.
bool is_wide(const Value& value);
/// The address that a base was made at; nullopt: it is none.
std::optional<Address> place_of(Base base);
/// The same by its bits alone: from 0 to 255, say.
Value resolved(const Value& value);

/// Sums of numbers that are not known, each of which is a number of its own: those of a pointer
/// and an index, say, so that two such sums differ by what is known.
class Sums {
 public:
  /// The same for the same numbers in any order; nullopt: of too many.
  std::optional<Base> of(Base a, Base b);
  /// The numbers of a sum, valid until of() is called; empty: it is none.
  [[nodiscard]] std::span<const Base> parts(Base base) const;

 private:
  using Parts = std::array<Base, 4>;  // in order, then 0

  std::vector<Parts> sums_;
  std::map<Parts, Base> known_;
};

/// Whether the numbers of two states are the same.
bool is_same(const State& a, const State& b);

/// Leaves the facts that hold on both ways to `at`.
void join(State& state, const State& other, Address at);

/// Applies an instruction that is no jump. A call leaves what a callee must preserve (AAPCS 6.1).
void apply(const Image& image, const Instruction& instruction, State& state, Sums& sums);

/// The core register ("r0", "sp") or the word of the floating-point unit ("s1"); nullopt: neither.
std::optional<std::size_t> register_of(std::string_view operand);

/// Whether a condition holds: nullopt if both are possible.
std::optional<bool> holds(Condition condition, const Comparison& comparison);

}  // namespace eagerx::gen::bound
