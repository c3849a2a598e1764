#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <new>
#include <runtime/host/base/exhaustion.hpp>
#include <runtime/host/base/interrupt.hpp>
#include <string_view>
#include <system_error>

namespace eagerx::host {
namespace {

constexpr int kExhausted = 3;

/// Allocates nothing.
[[noreturn]] void end(std::string_view text) {
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, text.data(), text.size());
  make_safe_now();
  _exit(kExhausted);
}

void without_memory() {
  end("error: there is not enough memory\n");
}

void uncaught() {
  try {
    if (std::current_exception()) std::rethrow_exception(std::current_exception());
  } catch (const std::system_error&) {
    end("error: the system has no more threads for this program\n");
  } catch (...) {
    std::abort();
  }
  std::abort();
}

}  // namespace

void end_when_exhausted() {
  std::set_new_handler(without_memory);
  std::set_terminate(uncaught);
}

}  // namespace eagerx::host
