// Parameters of entities as C++.
#pragma once

#include <string>

#include "generator/graph/resolve/graph.hpp"

namespace eagerx::gen {

/// A constant: "std::array<double, 1>", "{12.0}".
struct CppValue {
  std::string type, value;
};
CppValue cpp_value(const ConfigValue& item);

}  // namespace eagerx::gen
