// CRC-32C (Castagnoli): polynomial 0x1edc6f41, reflected, as in iSCSI (RFC 3720, appendix B.4).
#pragma once

#include <cstddef>
#include <cstdint>

namespace eagerx::link {

namespace detail {

// A nibble at a time: 64 bytes of flash instead of 1024.
struct CrcTable {
  std::uint32_t of[16];
  constexpr CrcTable() : of{} {
    constexpr std::uint32_t kReflected = 0x82f63b78U;
    for (std::uint32_t i = 0; i < 16; ++i) {
      std::uint32_t crc = i;
      for (int bit = 0; bit < 4; ++bit) crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? kReflected : 0U);
      of[i] = crc;
    }
  }
};
inline constexpr CrcTable kCrcTable{};

}  // namespace detail

/// The checksum of `size` bytes. `start` is the checksum of the preceding bytes, or 0. The headers
/// of the link do not inline such functions: this saves flash, and a line is slower than any call.
[[gnu::noinline]] constexpr std::uint32_t crc32c(const std::uint8_t* bytes, std::size_t size,
                                                 std::uint32_t start = 0) {
  std::uint32_t crc = ~start;
  for (std::size_t i = 0; i < size; ++i) {
    crc ^= bytes[i];
    crc = (crc >> 4U) ^ detail::kCrcTable.of[crc & 0xfU];
    crc = (crc >> 4U) ^ detail::kCrcTable.of[crc & 0xfU];
  }
  return ~crc;
}

}  // namespace eagerx::link
