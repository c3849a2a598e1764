// Arithmetic on values that are partly known.
#pragma once

#include "generator/analysis/bound/value.hpp"

namespace eagerx::gen::bound {

/// a + sign * b, if the sum has one base.
std::optional<Value> sum(const Value& a, const Value& b, int sign);

}  // namespace eagerx::gen::bound
