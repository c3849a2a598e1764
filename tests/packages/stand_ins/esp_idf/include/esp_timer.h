// ESP-IDF's timers: there is one.
#pragma once

#include <esp_task_wdt.h>
#include <freertos/task.h>

using esp_timer_handle_t = int*;
struct esp_timer_create_args_t {
  void (*callback)(void*);
  void* arg;
  int dispatch_method;
  const char* name;
  bool skip_unhandled_events;
};
inline std::int64_t esp_timer_get_time() {
  return static_cast<std::int64_t>(world::now_us);
}
inline esp_err_t esp_timer_create(const esp_timer_create_args_t* settings,
                                  esp_timer_handle_t* timer) {
  world::timer_callback = settings->callback;
  world::timer_argument = settings->arg;
  *timer = &world::task;
  return ESP_OK;
}
inline esp_err_t esp_timer_start_once(esp_timer_handle_t /*timer*/, std::uint64_t us) {
  if (world::timer_us != 0) return ESP_ERR_INVALID_STATE;
  world::timer_us = world::now_us + us;
  return ESP_OK;
}
inline esp_err_t esp_timer_stop(esp_timer_handle_t /*timer*/) {
  if (world::timer_us == 0) return ESP_ERR_INVALID_STATE;
  world::timer_us = 0;
  return ESP_OK;
}
