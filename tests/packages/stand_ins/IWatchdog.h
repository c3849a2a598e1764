// stm32duino's, on Linux.
#pragma once

#include "world.hpp"

#define IWDG_TIMEOUT_MAX 32760000
struct IWatchdogClass {
  void begin(std::uint32_t timeout_us) {
    if (timeout_us <= IWDG_TIMEOUT_MAX) world::start_watchdog(timeout_us);
  }
  void reload() { world::feed(); }
  bool isReset(bool /*clear*/) { return true; }
};
inline IWatchdogClass IWatchdog;
