// The last word of the command line, and results as text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/bus.hpp>
#include <string_view>
#include <targets/common/bare-metal/console.hpp>
#include <targets/common/bare-metal/semihosting.hpp>

namespace eagerx::board {

inline std::string_view last_word() {
  static char line[512];
  const int length = semihosting_command_line(line, sizeof line);
  std::string_view word(line, length < 0 ? 0 : static_cast<std::size_t>(length));
  word.remove_prefix(word.rfind(' ') + 1);
  return word;
}

inline void say(BusError error) {
  console.text(name_of(error));
}
template <class T>
void say(const char* name, T value) {
  console.text(name);
  console.text(" ");
  console.number(value);
  console.text("\n");
}
inline void say_bytes(BusError error, const std::uint8_t* bytes, std::size_t n) {
  say(error);
  for (std::size_t i = 0; i < n; ++i) {
    console.text(" ");
    console.hex(bytes[i]);
  }
  console.text("\n");
}

/// Ticks that `timer` counts while the core's clock counts `ns`.
template <class Timer, class Time>
std::uint64_t ticks_in(Timer& timer, std::int64_t ns) {
  const std::int64_t start = Time::now_ns();
  const std::uint64_t before = timer.ticks();
  Time::sleep_until(start + ns);
  return timer.ticks() - before;
}

}  // namespace eagerx::board
