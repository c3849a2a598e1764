// As much of Arduino's core as the sketches use, on Linux, with the macros that the AVR core has.
#pragma once

#include <cstdint>
#include <cstdio>

#include "world.hpp"

#define min(a, b) ((a) < (b) ? (a) : (b))
#define max(a, b) ((a) > (b) ? (a) : (b))
#define abs(x) ((x) > 0 ? (x) : -(x))
#define round(x) ((x) >= 0 ? (long)((x) + 0.5) : (long)((x)-0.5))
#define bit(b) (1UL << (b))
#define sq(x) ((x) * (x))
#define radians(deg) ((deg)*0.017453292519943295)
#define constrain(amt, low, high) ((amt) < (low) ? (low) : ((amt) > (high) ? (high) : (amt)))
#define F(string_literal) (string_literal)
#define count_of(a) (sizeof(a) / sizeof((a)[0]))
#define degrees(rad) ((rad)*57.295779513082320876798154814105)
#define interrupts() world::pass(0)
#define word(...) makeWord(__VA_ARGS__)
#define PI 3.1415926535897932384626433832795
#define INPUT 0x0
#define OUTPUT 0x1
#define HIGH 0x1
#define LOW 0x0

struct SerialPort {
  void begin(unsigned long) {}
  void print(const char* text) { std::fputs(text, stdout); }
  void print(char character) { std::fputc(character, stdout); }
  void println() { std::fputc('\n', stdout); }
  void println(const char* text) { std::puts(text); }
};
inline SerialPort Serial;

inline unsigned long micros() {
  return static_cast<std::uint32_t>(world::now_us);
}
inline void delay(unsigned long ms) {
  world::pass(ms * 1000);
}

#if defined(ARDUINO_ARCH_RP2040)
struct RP2040 {
  enum resetReason_t {
    UNKNOWN_RESET,
    PWRON_RESET,
    RUN_PIN_RESET,
    SOFT_RESET,
    WDT_RESET,
    DEBUG_RESET,
    GLITCH_RESET,
    BROWNOUT_RESET
  };
  resetReason_t getResetReason() { return WDT_RESET; }
  void wdt_begin(std::uint32_t ms) { world::start_watchdog(ms * std::uint64_t{1000}); }
  void wdt_reset() { world::feed(); }
};
inline RP2040 rp2040;
#endif
