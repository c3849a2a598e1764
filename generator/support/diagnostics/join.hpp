// Lists and counts as text, compiled once. With fmt::join, every stage would compile fmt's parsing
// and formatting again, up to 0.2 s of processor time each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <runtime/host/base/counted.hpp>
#include <set>
#include <span>
#include <string>
#include <string_view>

namespace eagerx::gen {

using host::counted;
using host::noun;

/// The items with `separator` between them; numbers in decimal, with the fewest digits: "4x3".
std::string join(std::span<const std::string> items, std::string_view separator);
std::string join(std::span<const std::string_view> items, std::string_view separator);
std::string join(std::span<const char* const> items, std::string_view separator);
std::string join(const std::set<std::string>& items, std::string_view separator);
std::string join(std::span<const std::int64_t> items, std::string_view separator);
std::string join(std::span<const std::size_t> items, std::string_view separator);
std::string join(std::span<const std::uint32_t> items, std::string_view separator);
std::string join(std::span<const double> items, std::string_view separator);

}  // namespace eagerx::gen
