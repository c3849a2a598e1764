// Sizes of memory as data sheets and linkers write them: "64K", "64 kB", "64 KiB", "1M".
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace eagerx::gen {

/// Bytes; a k is 1024 and an M is 1024 k, with or without a trailing B or iB. Also "1.5M" and
/// "0x400". nullopt for other text, for fractions of a byte, and for numbers that do not fit into
/// 63 bits.
std::optional<std::uint64_t> parse_bytes(std::string_view text);

/// The units, the common ones first.
const std::vector<std::string>& units_of_memory();

/// The correction of a size whose unit is wrong: "64 kib" → "64 KiB"; empty if there is
/// nothing near.
std::string with_right_unit_of_memory(std::string_view text);

}  // namespace eagerx::gen
