// When an instruction takes effect, by the flags.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace eagerx::gen::bound {

/// In the order of Arm's encoding (DDI 0403E A7.3), where the lowest bit inverts a condition.
enum class Condition : std::uint8_t {
  eq,
  ne,
  cs,
  cc,
  mi,
  pl,
  vs,
  vc,
  hi,
  ls,
  ge,
  lt,
  gt,
  le,
  always
};

/// The condition that holds where `condition` does not.
constexpr Condition opposite(Condition condition) {
  if (condition == Condition::always) return condition;
  return static_cast<Condition>(static_cast<std::uint8_t>(condition) ^ 1U);
}

/// "eq", "hs", "al"; nullopt: none.
std::optional<Condition> condition_named(std::string_view name);

}  // namespace eagerx::gen::bound
