#include <targets/common/bare-metal/console.hpp>
#include <targets/common/bare-metal/semihosting.hpp>

namespace eagerx::board {

constinit Console console{};

void Console::put(char character) {
  buffer_[used_++] = character;
  if (character == '\n' || used_ == kBufferBytes - 1) flush();  // one place for the final 0
}

void Console::text(std::string_view text) {
  for (const char character : text) put(character);
}

void Console::text(const char* text) {
  while (*text != '\0') put(*text++);
}

void Console::flush() {
  if (output_ == Output::uart) {
    for (std::size_t i = 0; i < used_; ++i) uart_write(buffer_[i]);
  } else if (used_ > 0) {
    buffer_[used_] = '\0';
    semihosting_write(buffer_);
  }
  used_ = 0;
}

}  // namespace eagerx::board
