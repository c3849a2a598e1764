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

/// Reads a file of new_key(). Only this user may have access to it. Empty, or the problem and its
/// fix.
std::string read_key(const std::string& path, Key& key);

/// Writes a new key, from the kernel's random numbers, to a path without a file, completely or not
/// at all. Empty, or the problem.
std::string new_key(const std::string& path);

}  // namespace eagerx::key
