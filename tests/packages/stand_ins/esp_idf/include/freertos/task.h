// FreeRTOS' tasks: there is one.
#pragma once

#include <freertos/FreeRTOS.h>

#include <cstdlib>

#include "world.hpp"

namespace world {
inline int task = 0;
inline unsigned notified = 0;
inline unsigned waits = 0;
inline std::uint64_t timer_us = 0;  // when the timer fires; 0: it does not run
inline void (*timer_callback)(void*) = nullptr;
inline void* timer_argument = nullptr;
}  // namespace world

inline TaskHandle_t xTaskGetCurrentTaskHandle() {
  return &world::task;
}
inline BaseType_t xTaskCreatePinnedToCore(TaskFunction_t run, const char* /*name*/,
                                          std::uint32_t stack, void* argument,
                                          UBaseType_t /*priority*/, TaskHandle_t* /*task*/,
                                          BaseType_t core) {
  if (stack < 4096 || core != 1) std::abort();
  run(argument);
  return pdTRUE;
}
inline void xTaskNotifyGive(TaskHandle_t task) {
  if (task != &world::task) std::abort();
  ++world::notified;
}
inline std::uint32_t ulTaskNotifyTake(BaseType_t /*clear*/, TickType_t /*wait*/) {
  if (world::timer_us == 0) std::abort();  // it would sleep for ever
  // Now and then another task notifies this one, before the timer does.
  if (++world::waits % 7 == 0 && world::timer_us > world::now_us) {
    world::pass((world::timer_us - world::now_us) / 2);
    return 1;
  }
  if (world::timer_us > world::now_us) world::pass(world::timer_us - world::now_us);
  world::timer_us = 0;
  world::timer_callback(world::timer_argument);
  const unsigned count = world::notified;
  world::notified = 0;
  return count;
}
inline void vTaskDelay(TickType_t ticks) {
  world::pass(ticks * std::uint64_t{10'000});
}
