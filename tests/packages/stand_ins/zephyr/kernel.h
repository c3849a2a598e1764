// Zephyr's kernel, on Linux, with 10,000 ticks a second.
#pragma once

#include <cstdint>

#include "world.hpp"

struct k_timeout_t {
  std::uint64_t until_us;
};
constexpr std::uint64_t kTickUs = 100;
#define K_SECONDS(s) (k_timeout_t{world::now_us + (s)*std::uint64_t{1'000'000}})
#define K_TIMEOUT_ABS_US(us) (k_timeout_t{((us) + kTickUs - 1) / kTickUs * kTickUs})
inline std::int64_t k_uptime_ticks() {
  return static_cast<std::int64_t>(world::now_us / kTickUs);
}
inline std::uint64_t k_ticks_to_us_floor64(std::int64_t ticks) {
  return static_cast<std::uint64_t>(ticks) * kTickUs;
}
inline std::int32_t k_sleep(k_timeout_t timeout) {
  if (timeout.until_us > world::now_us) world::pass(timeout.until_us - world::now_us);
  return 0;
}
