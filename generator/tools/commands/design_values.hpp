// `PORT=VALUE,…` of `eagerx-gen design`: what is tolerable, or how large noise is.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "generator/graph/plan/plan.hpp"

namespace eagerx::gen {

/// One value of an element of what NAME is.
struct NamedValue {
  std::string name;
  std::optional<std::size_t> element;  // that is written: "motor.y[2]"; without: all
  std::vector<std::string> values;     // as written, with units
};
/// The parts of "motor.y[2]=0.1 rad" or "motor.y=0.1,0.2"; nothing with E0522, as a wrong command
/// line.
std::optional<NamedValue> split_value(const std::string& option, const std::string& text,
                                      Diagnostics& diagnostics);

/// A positive number in `unit`: without a unit, with this one, or in deg for rad. Nothing with
/// E0522.
std::optional<double> positive_in(const std::string& unit, const std::string& option,
                                  const std::string& text, Diagnostics& diagnostics);

/// A value for each of `size` elements: one that is written for an element, or one for each.
/// Elements without one stay nothing. False with E0522.
bool spread_values(const std::string& option, const NamedValue& value, const std::string& unit,
                   std::vector<std::optional<double>>& elements, Diagnostics& diagnostics);

}  // namespace eagerx::gen
