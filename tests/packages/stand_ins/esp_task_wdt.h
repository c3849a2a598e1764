// ESP-IDF 5's, on Linux.
#pragma once

#include <cstdint>

#include "world.hpp"

using esp_err_t = int;
constexpr esp_err_t ESP_OK = 0;
constexpr esp_err_t ESP_ERR_INVALID_STATE = 0x103;
#define ESP_ERROR_CHECK(x) ((x) == ESP_OK ? static_cast<void>(0) : std::abort())

struct esp_task_wdt_config_t {
  std::uint32_t timeout_ms;
  std::uint32_t idle_core_mask;
  bool trigger_panic;
};
namespace world {
inline std::uint64_t task_watchdog_us = 0;
}
inline esp_err_t esp_task_wdt_init(const esp_task_wdt_config_t* config) {
  if (!config->trigger_panic) std::abort();
  world::task_watchdog_us = config->timeout_ms * std::uint64_t{1000};
  return ESP_OK;
}
/// CONFIG_ESP_TASK_WDT_INIT decides whether it runs before the program; here it does not.
inline esp_err_t esp_task_wdt_reconfigure(const esp_task_wdt_config_t* /*config*/) {
  return ESP_ERR_INVALID_STATE;
}
inline esp_err_t esp_task_wdt_add(void* /*task*/) {
  world::start_watchdog(world::task_watchdog_us);
  return ESP_OK;
}
inline esp_err_t esp_task_wdt_reset() {
  world::feed();
  return ESP_OK;
}
