// Zephyr's watchdogs: one that cannot pause.
#pragma once

#include <zephyr/device.h>

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
inline std::uint64_t window_us = 0;
}
inline int wdt_install_timeout(const device* /*of*/, const wdt_timeout_cfg* config) {
  if (config->window.min != 0 || config->flags != WDT_FLAG_RESET_SOC) return -1;
  world::window_us = config->window.max * std::uint64_t{1000};
  return 0;
}
inline int wdt_setup(const device* /*of*/, std::uint8_t options) {
  if (options != 0) return -134;
  world::start_watchdog(world::window_us);
  return 0;
}
inline int wdt_feed(const device* /*of*/, int channel) {
  if (channel != 0) return -1;
  world::feed();
  return 0;
}
