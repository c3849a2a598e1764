// Shared by the main program of a package and its hardware.h.
#pragma once

#include <cstddef>
#include <cstdint>

namespace eagerx {

/// The cause of the chip's reset, as far as its core reports it; passed to `begin(ResetReason)` of
/// hardware.h.
enum class ResetReason : std::uint8_t { unknown, power_on, pin, software, watchdog, brown_out };

/// The guard of a graph without actions.
struct NoGuard {
  template <class F>
  void for_each_count(F&& /*f*/) const {}
};

/// For a hardware.h without these lists.
namespace no_names {
inline constexpr const char* kMeasurements[] = {""};
inline constexpr const char* kOutputs[] = {""};
}  // namespace no_names

/// Whether `name` is one of `names`.
template <std::size_t N>
constexpr bool has_name(const char* const (&names)[N], const char* name) {
  for (const char* candidate : names) {
    std::size_t i = 0;
    while (candidate[i] != '\0' && candidate[i] == name[i]) ++i;
    if (candidate[i] == name[i]) return true;
  }
  return false;
}

}  // namespace eagerx
