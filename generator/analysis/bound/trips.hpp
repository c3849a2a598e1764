// How often a loop turns, from what changes in it and when it is left.
#pragma once

#include <functional>
#include <optional>

#include "generator/analysis/bound/value.hpp"

namespace eagerx::gen::bound {

/// A number that starts somewhere and grows by a step, each turn.
struct Progress {
  Value start, step;
};

/// A test of a loop that every turn makes: it stays while the condition holds.
struct Test {
  Comparison comparison;
  Condition stays_while = Condition::always;
};

struct Turns {
  std::uint64_t most = 0;  // tests, the last one included
  bool is_exact = false;
};

/// The value at the first turn of the loop's body, and its change from turn to turn; nullopt: not
/// known.
using ProgressOf = std::function<std::optional<Progress>(const Value&)>;
/// `state`: where the loop is entered.
std::optional<Turns> turns_of(const Test& test, const ProgressOf& progress_of, const State& state);

}  // namespace eagerx::gen::bound
