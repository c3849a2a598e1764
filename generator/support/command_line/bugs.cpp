#include "generator/support/command_line/bugs.hpp"

#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>

#include "generator/support/command_line/command_line.hpp"

namespace eagerx::gen {
namespace {

constexpr const char* kHelp = "help: please report it with the graph\n";
const char* volatile aborted_program = "";

void write_error(const char* text) {
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, text, std::strlen(text));
}

/// Nothing but what a handler of signals may call.
void on_abort(int /*signal*/) {
  write_error("error: this is a bug in ");
  write_error(aborted_program);
  write_error(": it has aborted\n");
  write_error(kHelp);
  _exit(kInternal);
}

}  // namespace

int reporting_bugs(const char* program, const std::function<int()>& action) {
  aborted_program = program;
  static_cast<void>(std::signal(SIGABRT, on_abort));
  try {
    return action();
  } catch (const std::bad_alloc&) {
    write_error("error: there is not enough memory\n");
    return kInputOutput;
  } catch (const std::exception& error) {
    static_cast<void>(
        std::fprintf(stderr, "error: this is a bug in %s: %s\n%s", program, error.what(), kHelp));
    return kInternal;
  }
}

}  // namespace eagerx::gen
