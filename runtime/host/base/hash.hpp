// The hash of bytes that identifies files and programs.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace eagerx::host {

/// FNV-1a, 64 bits; continued from `hash`.
constexpr std::uint64_t fnv1a(std::string_view bytes, std::uint64_t hash = 0xcbf29ce484222325U) {
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return hash;
}

/// "0x0123456789abcdef"
inline std::string hex_text(std::uint64_t number) {
  constexpr unsigned kBits = 64, kBitsPerDigit = 4;
  std::string text = "0x";
  for (unsigned shift = kBits; shift > 0;) {
    shift -= kBitsPerDigit;
    text += "0123456789abcdef"[(number >> shift) & 0xfU];
  }
  return text;
}

}  // namespace eagerx::host
