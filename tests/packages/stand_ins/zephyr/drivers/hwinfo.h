// Zephyr's, on Linux.
#pragma once

#include <cstdint>

#define RESET_PIN 0x1
#define RESET_SOFTWARE 0x2
#define RESET_BROWNOUT 0x4
#define RESET_POR 0x8
#define RESET_WATCHDOG 0x10
inline int hwinfo_get_reset_cause(std::uint32_t* cause) {
  *cause = RESET_WATCHDOG | RESET_PIN;
  return 0;
}
inline int hwinfo_clear_reset_cause() {
  return 0;
}
