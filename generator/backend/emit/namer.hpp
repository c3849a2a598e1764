// Makes every name in generated code, so that casing and uniqueness are decided in one place.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "generator/graph/resolve/graph.hpp"

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
/// "pendulum/u_applied" → "pendulum_u_applied", "arm/leg[2]" → "arm_leg_2"
std::string snake(std::string_view name);
/// 29.97 Hz → "29p97Hz", 30/7 Hz → "30over7Hz"
std::string rate_suffix(const Rational& rate_hz);

/// "eagerx::Rate<30>", "eagerx::Rate<30, 7>"
std::string rate_type(const Rational& rate_hz);
/// The names of numbers: by their C++ types, as SIMD vectors of them, "F32", or with derivatives,
/// which integers have not.
enum class Numbers : std::uint8_t { plain, simd, dual };

/// "float", "std::int8_t"
std::string_view element_type(Dtype dtype, Numbers numbers = Numbers::plain);
/// "float", "eagerx::Array<float, 2>"
std::string message_type(const Space& space, Numbers numbers = Numbers::plain);
}  // namespace eagerx::gen
