// FreeRTOS as ESP-IDF has it, on Linux.
#pragma once

#include <cstdint>

using BaseType_t = int;
using UBaseType_t = unsigned;
using TickType_t = std::uint32_t;
using TaskHandle_t = void*;
using TaskFunction_t = void (*)(void*);
#define pdTRUE 1
#define portMAX_DELAY 0xffffffffU
#define portNUM_PROCESSORS 2
#define pdMS_TO_TICKS(ms) ((ms) / 10)
