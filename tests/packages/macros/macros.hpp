// Macros that Arduino's cores for rp2040, stm32 and Teensy 4 define for a sketch. Here each
// expands to something that does not compile, so that a header which meets one is found.
// tests/packages/real_tools takes all of the real ones.
#pragma once

// Headers of the C and C++ libraries come before the macros, as in a core.
#include <algorithm>
#include <array>
#include <bit>
#include <cfloat>
#include <climits>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <limits>
#include <new>
#include <optional>
#include <span>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>

// Of Arduino.
#define F(...) @
#define PSTR(...) @
#define bit(...) @
#define bitClear(...) @
#define bitRead(...) @
#define bitSet(...) @
#define bitToggle(...) @
#define bitWrite(...) @
#define clockCyclesPerMicrosecond(...) @
#define constrain(...) @
#define degrees(...) @
#define highByte(...) @
#define interrupts(...) @
#define lowByte(...) @
#define noInterrupts(...) @
#define radians(...) @
#define sq(...) @
#define word(...) @
#define A0 @
#define A1 @
#define BIN @
#define CHANGE @
#define DEC @
#define DEFAULT @
#define DISPLAY @
#define EULER @
#define FALLING @
#define HALF_PI @
#define HEX @
#define HIGH @
#define INPUT @
#define INPUT_PULLUP @
#define LED_BUILTIN @
#define LOW @
#define LSBFIRST @
#define MSBFIRST @
#define OCT @
#define OUTPUT @
#define PI @
#define PROGMEM @
#define RISING @
#define SERIAL @
#define TWO_PI @

// Of one of the cores, its SDK or its C library.
#define CLEAR_BIT(...) @
#define MAX(...) @
#define MIN(...) @
#define MODIFY_REG(...) @
#define READ_REG(...) @
#define SET_BIT(...) @
#define UNUSED(...) @
#define WRITE_REG(...) @
#define assert_param(...) @
#define bool_to_bit(...) @
#define cbi(...) @
#define cli(...) @
#define count_of(...) @
#define hard_assert_if(...) @
#define panic_compact(...) @
#define sbi(...) @
#define sei(...) @
#define stricmp(...) @
#define valid_params_if(...) @
#define ADC @
#define ADC1 @
#define CAN1 @
#define CRC @
#define DAC @
#define DMA1 @
#define DMAMEM @
#define DWT @
#define EXTI @
#define FASTRUN @
#define FLASH @
#define FPU @
#define GPIOA @
#define I2C1 @
#define ITM @
#define IWDG @
#define MPU @
#define NVIC @
#define PA0 @
#define PB1 @
#define PWR @
#define RCC @
#define RTC @
#define SCB @
#define SPI1 @
#define SYSCFG @
#define SysTick @
#define TIM1 @
#define TIM2 @
#define USART1 @
#define WEAK @
#define WWDG @
#define dma_hw @
#define hard_assert @
#define pio0 @
#define pio1 @
#define timer_hw @
#define uart0 @
#define uart1 @
#define watchdog_hw @
