// The functions of expressions that work element by element, and their names in other languages.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace eagerx::expression {

/// A function of numbers, by its name in eagerx/math.hpp.
struct Function {
  std::string_view name;
  std::size_t arguments;
};
/// The functions that work element by element, except min, max and angle_of.
std::span<const Function> functions();

/// The help for a function of another language or library, such as `np.exp` or `square`; empty if
/// the name is none. `known`: all names that expressions have.
std::string help_with_other_name(std::string_view name, const std::vector<std::string>& known);

}  // namespace eagerx::expression
