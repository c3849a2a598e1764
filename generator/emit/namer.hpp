// Every name in generated code comes from here: one place for casing, uniqueness and literals.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "generator/resolve/graph.hpp"

namespace eagerx::gen {

/// Hands out names that are unique in their scope: the second `a_b` becomes `a_b_2`.
class Names {
 public:
  std::string unique(const std::string& wanted);
  /// The same, where the name with `suffix` is needed too.
  std::string unique_with(const std::string& wanted, const std::string& suffix);
  [[nodiscard]] bool has(const std::string& name) const { return used_.contains(name); }

 private:
  std::map<std::string, int> used_;
};

/// "pendulum/u_applied" → "PendulumUApplied"
std::string camel(std::string_view name);
/// "pendulum/u_applied" → "pendulum_u_applied"
std::string snake(std::string_view name);
/// 29.97 Hz → "29p97Hz", 30/7 Hz → "30over7Hz"
std::string rate_suffix(const Rational& rate_hz);

/// "eagerx::Rate<30>", "eagerx::Rate<30, 7>"
std::string rate_type(const Rational& rate_hz);
/// "float", "eagerx::Array<float, 2>"
std::string message_type(const Space& space);
/// A C++ literal with exactly this value as the element type of a message: "2.0F", "-1", "true".
std::string literal(double value, Dtype dtype);
/// A double literal: "0.1", "1e-08".
std::string double_literal(double value);
/// A message with these values, one for all elements or one for each: "{{1.0F, 2.0F}}", "2.0F".
std::string message_literal(const std::vector<double>& values, const Space& space);
/// "eagerx::Space<M>{.low = …, .high = …}" without the type; missing bounds are the dtype's.
std::string space_literal(const Space& space);
/// A string literal with its quotes.
std::string string_literal(std::string_view text);

}  // namespace eagerx::gen
