// The key that two machines share: a file that only its owner may read.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace eagerx::key {

inline constexpr std::size_t kKeyBytes = 32;
/// Secret: its holders are trusted.
using Key = std::array<std::uint8_t, kKeyBytes>;

/// Reads a file that new_key() wrote. Nothing but this user may be able to read or write it. Empty,
/// or what is wrong with it, and what to do.
std::string read_key(const std::string& path, Key& key);

/// Writes a new key, of the kernel's random numbers, where no file is. It is there as a whole or
/// not at all. Empty, or what is wrong.
std::string new_key(const std::string& path);

}  // namespace eagerx::key
