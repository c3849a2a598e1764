// Shapes of tensors, and numbers that C++ has no type for.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace eagerx::gen {

using Dims = std::vector<std::int64_t>;  // each at least 0, product below kMaxElements

inline constexpr std::int64_t kMaxElements = std::int64_t{1} << 40U;

/// Product of `dims`; nothing for a negative dimension or more than kMaxElements.
std::optional<std::int64_t> element_count(const Dims& dims);

/// Index `at` among `count`, counted from the end if negative; nullopt if out of range.
std::optional<std::int64_t> place_in(std::int64_t at, std::int64_t count);

/// "[64, 3]".
std::string show(const Dims& dims);

/// The float16 with these bits.
double half(std::uint16_t bits);

}  // namespace eagerx::gen
