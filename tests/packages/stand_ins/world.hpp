// A machine for main loops of packages: time that passes as a test says, and a watchdog.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace world {

inline std::uint64_t now_us = 4'294'000'000;  // Arduino's micros() overflow after 1 s
inline std::uint64_t watchdog_us = 0;         // 0: it does not run
inline std::uint64_t fed_us = 0;

/// Time passes, and a watchdog that was forgotten ends the program.
inline void pass(std::uint64_t us) {
  now_us += us;
  if (watchdog_us == 0 || now_us - fed_us <= watchdog_us) return;
  std::printf("reset by the watchdog\n");
  std::exit(0);
}
inline void feed() {
  fed_us = now_us;
}
inline void start_watchdog(std::uint64_t us) {
  std::printf("watchdog %llu ms\n", static_cast<unsigned long long>(us / 1000));
  watchdog_us = us;
  feed();
}

}  // namespace world
