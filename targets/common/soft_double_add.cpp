// Replaces libgcc's addition of doubles (see soft_double_add.hpp for why). Link boards without a
// double unit with
//   -Wl,--wrap=__aeabi_dadd,--wrap=__aeabi_dsub,--wrap=__aeabi_drsub
// The ABI passes doubles to these functions in integer registers, with hard floats too.
#include "targets/common/soft_double_add.hpp"

#include <cstdint>

extern "C" {

std::uint64_t __wrap___aeabi_dadd(std::uint64_t a, std::uint64_t b);
std::uint64_t __wrap___aeabi_dsub(std::uint64_t a, std::uint64_t b);
std::uint64_t __wrap___aeabi_drsub(std::uint64_t a, std::uint64_t b);

std::uint64_t __wrap___aeabi_dadd(std::uint64_t a, std::uint64_t b) {
  return eagerx::board::add_doubles(a, b);
}

std::uint64_t __wrap___aeabi_dsub(std::uint64_t a, std::uint64_t b) {
  return eagerx::board::subtract_doubles(a, b);
}

/// b - a, the other way round.
std::uint64_t __wrap___aeabi_drsub(std::uint64_t a, std::uint64_t b) {
  return eagerx::board::subtract_doubles(b, a);
}
}
