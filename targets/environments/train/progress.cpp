#include "targets/environments/train/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

namespace eagerx::train {

Progress::Progress(std::uint64_t first_step, std::uint64_t last_step, bool has_success,
                   bool is_quiet, std::string name)
    : first_step_(first_step),
      last_step_(last_step),
      has_success_(has_success),
      is_quiet_(is_quiet),
      name_(std::move(name)),
      is_terminal_(name_.empty() && isatty(STDERR_FILENO) == 1),
      last_return_(std::numeric_limits<double>::quiet_NaN()),
      last_evaluation_(last_return_),
      last_success_(last_return_),
      start_(Clock::now()),
      shown_(start_) {}

double Progress::seconds() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

void Progress::show(const CurvePoint& point, const std::string& stage) {
  if (!std::isnan(point.mean_return)) last_return_ = point.mean_return;
  if (!std::isnan(point.evaluation_return)) last_evaluation_ = point.evaluation_return;
  if (!std::isnan(point.evaluation_success)) last_success_ = point.evaluation_success;
  using namespace std::chrono_literals;
  const auto now = Clock::now();
  if (is_quiet_ || now - shown_ < (is_terminal_ ? 1s : 5s)) return;
  shown_ = now;
  const std::string text = line(point, stage, seconds());
  if (is_terminal_) {
    fmt::print(stderr, "\r{}\x1b[K", text);
  } else {
    fmt::print(stderr, "{}\n", text);
  }
  std::fflush(stderr);
  is_shown_ = is_terminal_;
}

void Progress::finish() {
  if (is_shown_) fmt::print(stderr, "\r\x1b[K");
  is_shown_ = false;
}

void Progress::begin_stage(const std::string& line) {
  last_return_ = std::numeric_limits<double>::quiet_NaN();
  say(line);
}

void Progress::say(const std::string& line) {
  if (is_quiet_) return;
  finish();
  fmt::print(stderr, "{}{}{}\n", name_, name_.empty() ? "" : ": ", line);
}

std::string Progress::line(const CurvePoint& point, const std::string& stage,
                           double seconds) const {
  const double here = point.steps - static_cast<double>(first_step_);
  const double left = std::max(0.0, static_cast<double>(last_step_) - point.steps);
  std::string text = name_.empty() ? std::string() : name_ + ": ";
  constexpr double kMillion = 1e6;
  const auto last = static_cast<double>(last_step_);
  text += last < kMillion
              ? fmt::format("{} of {} steps", rounded(point.steps), rounded(last))
              : fmt::format("{:.2f} of {:.2f} M steps", point.steps / kMillion, last / kMillion);
  if (!stage.empty()) text += ", " + stage;
  if (!std::isnan(last_return_)) text += fmt::format(", return {:.4g}", last_return_);
  if (!std::isnan(last_evaluation_)) text += fmt::format(", evaluation {:.4g}", last_evaluation_);
  if (has_success_ && !std::isnan(last_success_)) {
    text += fmt::format(", success {:.0f} of 100", 100.0 * last_success_);
  }
  return text + fmt::format(", {} steps/s, at most {} left", rounded(here / seconds),
                            minutes(seconds * left / here));
}

}  // namespace eagerx::train
