#include "generator/support/command_line/output.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "generator/support/command_line/command_line.hpp"
#include "generator/support/diagnostics/utf8.hpp"

namespace eagerx::gen {
namespace {

int first_problem = 0;  // errno; 0: none, or reported
bool broken = false;    // what comes later has no place either

void note_problem() {
  if (!broken) first_problem = errno;
  broken = true;
}

/// Makes the text between `ends` printable.
std::string drawable(std::string_view text, std::string_view ends = "\n") {
  std::string result;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find_first_of(ends, begin), text.size());
    result += escape_unprintable(text.substr(begin, end - begin));
    if (end < text.size()) result += text[end];
    begin = end + 1;
  }
  return result;
}

void print(const std::string& bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size()) note_problem();
}

}  // namespace

void say_text(std::string_view text) {
  if (!broken) print(drawable(text));
}

void say_table(std::string_view text) {
  if (!broken) print(drawable(text, "\n\t"));
}

void complain_text(std::string_view text) {
  const std::string bytes = drawable(text);
  static_cast<void>(std::fwrite(bytes.data(), 1, bytes.size(), stderr));  // nowhere to tell it
}

std::optional<std::string> flush_output() {
  if (!broken && std::fflush(stdout) != 0) note_problem();
  if (first_problem == 0) return std::nullopt;
  return std::strerror(std::exchange(first_problem, 0));
}

void report_output(const std::string& why, Diagnostics& diagnostics) {
  diagnostics.io_error("E0901", {}, fmt::format("cannot write the standard output: {}", why));
}

void open_standard_descriptors() {
  // open() gives the lowest number that is free. What is printed to a closed output fails; errors
  // have nowhere to go.
  for (int number = STDIN_FILENO; number <= STDERR_FILENO; ++number) {
    const int mode = number == STDERR_FILENO ? O_RDWR : O_RDONLY;
    if (fcntl(number, F_GETFD) == -1 && errno == EBADF && open("/dev/null", mode) != number)
      std::_Exit(kInputOutput);
  }
}

}  // namespace eagerx::gen
