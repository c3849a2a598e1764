// Zephyr's watchdogs, as wdt_iwdg_stm32.c is: one that takes one timeout, that of its start at boot
// if it is not off there, and cannot pause; with WINDOW_WATCHDOG one that waits 50 ms at most.
#pragma once

#include <zephyr/device.h>

#include <cerrno>

#include "world.hpp"

#define WDT_FLAG_RESET_SOC 2
#define WDT_OPT_PAUSE_HALTED_BY_DBG 2
struct wdt_window {
  std::uint32_t min, max;
};
struct wdt_timeout_cfg {
  wdt_window window;
  void (*callback)(const device*, int);
  std::uint8_t flags;
};
namespace world {
#ifdef CONFIG_WDT_DISABLE_AT_BOOT
inline std::uint64_t window_us = 0;
#else
inline std::uint64_t window_us = 100'000;  // CONFIG_IWDG_STM32_INITIAL_TIMEOUT
#endif
#ifdef WINDOW_WATCHDOG
inline constexpr std::uint64_t kLongestWindowUs = 50'000;
#else
inline constexpr std::uint64_t kLongestWindowUs = 26'214'000;
#endif
}  // namespace world
inline int wdt_install_timeout(const device* /*of*/, const wdt_timeout_cfg* config) {
  if (config->window.min != 0 || config->flags != WDT_FLAG_RESET_SOC) return -EINVAL;
  const std::uint64_t us = config->window.max * std::uint64_t{1000};
  if (us == 0 || us > world::kLongestWindowUs) return -EINVAL;
  if (world::window_us != 0) return -ENOMEM;
  world::window_us = us;
  return 0;
}
inline int wdt_setup(const device* /*of*/, std::uint8_t options) {
  if (options != 0) return -ENOTSUP;
  if (world::window_us == 0) return -EINVAL;
  world::start_watchdog(world::window_us);
  return 0;
}
inline int wdt_feed(const device* /*of*/, int channel) {
  if (channel != 0) return -EINVAL;
  world::feed();
  return 0;
}
