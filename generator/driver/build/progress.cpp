#include "generator/driver/build/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

namespace eagerx::gen {
namespace {

constexpr double kFirst_s = 0.5;
constexpr double kPeriod_s = 3.0;

}  // namespace

Progress::Progress(std::string what, bool quiet)
    : what_(std::move(what)),
      quiet_(quiet),
      terminal_(isatty(STDERR_FILENO) == 1),
      next_s_(kFirst_s) {}

double Progress::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

void Progress::at(const std::string& done) {
  const double now_s = seconds();
  if (quiet_ || now_s < next_s_) return;
  next_s_ = terminal_ ? now_s + kFirst_s : now_s + kPeriod_s;
  show(fmt::format("{}: {}{}{:.0f} s", what_, done, done.empty() ? "" : ", ", now_s));
}

void Progress::finish(bool good) {
  if (!shown_) return;
  show(good ? fmt::format("{}: done after {:.0f} s", what_, seconds()) : "");
  if (terminal_ && good) std::fputs("\n", stderr);
}

void Progress::show(const std::string& text) {
  if (terminal_) {
    std::fputs(("\r\x1b[K" + text).c_str(), stderr);
  } else if (!text.empty()) {
    std::fputs((text + "\n").c_str(), stderr);
  }
  std::fflush(stderr);
  shown_ = true;
}

}  // namespace eagerx::gen
