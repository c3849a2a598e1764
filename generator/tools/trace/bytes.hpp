// Binary files, little-endian.
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>

namespace eagerx::gen {

template <std::unsigned_integral T>
void append(std::string& to, T value) {
  for (std::size_t i = 0; i < sizeof(T); ++i)
    to += static_cast<char>(static_cast<std::uint8_t>(value >> (8 * i)));
}

/// CRC-32 (IEEE 802.3), as zip and MCAP have it.
std::uint32_t crc32_of(std::string_view bytes);

}  // namespace eagerx::gen
