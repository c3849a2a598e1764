// stm32duino's, on Linux.
#pragma once

#include "world.hpp"

struct IWatchdogClass {
  void begin(std::uint32_t timeout_us) { world::start_watchdog(timeout_us); }
  void reload() { world::feed(); }
};
inline IWatchdogClass IWatchdog;
