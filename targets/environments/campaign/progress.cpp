#include "targets/environments/campaign/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "targets/environments/client/words.hpp"

namespace eagerx::campaign {

Progress::Progress(std::uint32_t runs, bool is_quiet)
    : runs_(runs),
      is_quiet_(is_quiet),
      is_terminal_(isatty(STDERR_FILENO) == 1),
      start_(Clock::now()),
      shown_(start_) {}

void Progress::begin(std::uint32_t done) {
  before_ = done;
}

void Progress::show(std::uint32_t done, std::uint32_t successes) {
  using namespace std::chrono_literals;
  const auto now = Clock::now();
  if (is_quiet_ || now - shown_ < (is_terminal_ ? 1s : 5s)) return;
  shown_ = now;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const double rate_hz = (done - before_) / seconds;
  fmt::print(stderr, "{}{} of {} runs, success {:.1f} %, {} runs/s, {} left{}",
             is_terminal_ ? "\r" : "", done, runs_, 100.0 * successes / done,
             client::rounded(rate_hz), client::minutes((runs_ - done) / rate_hz),
             is_terminal_ ? "\x1b[K" : "\n");
  std::fflush(stderr);
  is_shown_ = is_terminal_;
}

void Progress::finish() {
  if (is_shown_) fmt::print(stderr, "\r\x1b[K");
  is_shown_ = false;
}

}  // namespace eagerx::campaign
