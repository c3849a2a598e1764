// The contents of `budget:` as written.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "generator/frontend/spec/settings.hpp"

namespace eagerx::gen {

/// The bytes that a node may take.
struct NodeBudgetSpec {
  Spanned<std::string> name;
  std::optional<Spanned<std::uint64_t>> flash, ram;
};

/// A limit of the age of data; without names it is one for all pairs.
struct AgeBudgetSpec {
  Spanned<Rational> at_most_s;
  std::optional<Spanned<std::string>> from, to;
  std::optional<Spanned<bool>> agent;
};

/// The least stability margins of the loop that is opened at a port.
struct MarginBudgetSpec {
  Spanned<std::string> at;
  std::optional<Spanned<Rational>> phase_deg, gain_db, delay_s;
  bool trim = false, corners = false;
};

struct BudgetSpec {
  std::optional<Spanned<std::uint64_t>> flash, ram, stack;  // bytes of an image
  std::optional<Spanned<std::uint64_t>> instructions;       // of a slot
  std::optional<Spanned<Rational>> time, slot;              // a share of it; seconds
  std::vector<MarginBudgetSpec> margins;
  std::optional<std::vector<NodeBudgetSpec>> nodes;         // not there: the key is not
  std::optional<std::vector<AgeBudgetSpec>> ages;           // the same
  std::optional<Spanned<Rational>> link, parts, telemetry;  // baud

  [[nodiscard]] bool is_of_plan() const { return ages || link || parts || telemetry; }
};

/// Of a tree that `check` has accepted and whose times are numbers.
BudgetSpec read_budget(const YamlValue& yaml);

}  // namespace eagerx::gen
