// Every value in generated code is written here.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "generator/graph/resolve/graph.hpp"

namespace eagerx::gen {

/// A C++ literal with exactly this value as the element type of a message: "2.0F", "-1", "true".
std::string literal(double value, Dtype dtype);
/// The shortest literals with exactly these values: "0.1", "1e-08"; "0.1F".
std::string double_literal(double value);
std::string float_literal(float value);
/// "int" where it is enough, else "std::int64_t"; and a literal that either takes.
std::string int_type(std::int64_t value);
std::string int_literal(std::int64_t value);
/// "true", "false"
std::string bool_literal(bool value);
/// A message with these values, one for all elements or one for each: "{{1.0F, 2.0F}}", "2.0F".
std::string message_literal(const std::vector<double>& values, const Space& space);
/// "eagerx::Space<M>{.low = …, .high = …}" without the type; missing bounds are the dtype's.
std::string space_literal(const Space& space);

/// "a, b, c"
std::string joined(const std::vector<std::string>& items);
/// "{a, b, c}"
std::string braced(const std::vector<std::string>& items);
/// A value and the field that it is for.
struct FieldValue {
  std::string field, value;
};
/// "{.a = 1, .b = 2}": another order, or another field, does not compile.
std::string designated(const std::vector<FieldValue>& items);

}  // namespace eagerx::gen
