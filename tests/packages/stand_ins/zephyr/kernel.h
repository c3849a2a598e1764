// Zephyr's kernel, on Linux.
#pragma once

#include <cstdint>

#include "world.hpp"

struct k_timeout_t {
  std::uint64_t until_us;
};
#ifndef CONFIG_SYS_CLOCK_TICKS_PER_SEC
#define CONFIG_SYS_CLOCK_TICKS_PER_SEC 10000
#endif
constexpr std::uint64_t kTickUs = 1'000'000 / CONFIG_SYS_CLOCK_TICKS_PER_SEC;
#define K_SECONDS(s) (k_timeout_t{world::now_us + (s)*std::uint64_t{1'000'000}})
#define K_TIMEOUT_ABS_US(us) (k_timeout_t{((us) + kTickUs - 1) / kTickUs * kTickUs})
inline std::int64_t k_uptime_ticks() {
  return static_cast<std::int64_t>(world::now_us / kTickUs);
}
inline std::uint64_t k_ticks_to_us_floor64(std::int64_t ticks) {
  return static_cast<std::uint64_t>(ticks) * kTickUs;
}
inline std::int32_t k_sleep(k_timeout_t timeout) {
  if (timeout.until_us <= world::now_us) return 0;
  const std::uint64_t rest_us = timeout.until_us - world::now_us;
  static unsigned sleeps = 0;
  world::pass(++sleeps % 7 == 0 ? rest_us / 2 : rest_us);  // k_wakeup() of another thread
  return 0;
}
