// CRC-32 (IEEE 802.3), as PNG, zip and MCAP have it.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace eagerx {

class Crc32 {
 public:
  void add(std::string_view bytes) {
    for (const char each : bytes)
      crc_ = kTable[(crc_ ^ static_cast<unsigned char>(each)) & 0xffU] ^ (crc_ >> 8U);
  }
  std::uint32_t value() const { return ~crc_; }

 private:
  static constexpr std::array<std::uint32_t, 256> kTable = [] {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t n = 0; n < 256; ++n) {
      std::uint32_t c = n;
      for (int k = 0; k < 8; ++k) c = (c & 1U) != 0 ? 0xedb88320U ^ (c >> 1U) : c >> 1U;
      table[n] = c;
    }
    return table;
  }();
  std::uint32_t crc_ = 0xffffffffU;
};

inline std::uint32_t crc32_of(std::string_view bytes) {
  Crc32 crc;
  crc.add(bytes);
  return crc.value();
}

}  // namespace eagerx
