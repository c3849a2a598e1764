// Delays without slopes: the cost has walls where a sensor reads the input.
#include <algorithm>
#include <cmath>
#include <limits>
#include <runtime/host/identify/least_squares.hpp>

namespace eagerx::identification {

/// Next to a wall a difference has both sides of it in its slope, so Gauss' and Newton's steps end
/// there before the minimum, up to a step of the difference away. Each delay is searched again with
/// the other parameters fitted at each try, and then they are fitted once more.
bool LeastSquares::settle_delays(Trial& trial) {
  constexpr int kSteps = 15;
  constexpr double kStep = kParameterStep, kFinerStep = kParameterStep / 16;  // of half the range
  if (first_delay_ == ranges_.size()) return true;
  const auto hold = [this](bool is_held) {
    std::fill(is_held_.begin() + static_cast<std::ptrdiff_t>(first_delay_), is_held_.end(),
              is_held);
  };
  hold(true);
  bool numbers = descend(trial, kSteps);
  // The second time with the noise that is left over after the first.
  for (const double step : {kStep, kFinerStep}) {
    for (std::size_t p = first_delay_; p < ranges_.size() && numbers; ++p)
      numbers = settle(trial, p, step * half(p));
    weigh(run_(trial));
    numbers = numbers && descend(trial, kSteps);
  }
  hold(false);
  last_ = run_(trial);
  weigh(last_);
  return numbers;
}

/// Compass search (Kolda, Lewis and Torczon, SIAM Review 45, 2003): the step is halved where
/// neither side is better, until it does not matter. False if the program gives no numbers.
bool LeastSquares::settle(Trial& trial, std::size_t delay, double step) {
  constexpr int kTries = 40;
  constexpr double kNothing = 1e-2;  // of the cost: a tenth of a standard deviation
  double least = cost(trial, run_(trial));
  for (int tries = 0; tries < kTries && std::isfinite(least); ++tries) {
    double more = std::numeric_limits<double>::infinity();  // to the better side
    bool is_better = false;
    for (const double side : {-1.0, 1.0}) {
      Trial tried = trial;
      const double found = cost_of_delay(tried, delay, trial.parameters[delay] + side * step);
      is_better = found < (1.0 - kDone) * least;
      if (is_better) {
        trial = tried;
        least = found;
        break;
      }
      more = std::min(more, found - least);
    }
    if (!is_better && more < kNothing) break;
    if (!is_better) step /= 2;
  }
  return std::isfinite(least);
}

/// With the other parameters fitted. Infinity beyond the range.
double LeastSquares::cost_of_delay(Trial& trial, std::size_t delay, double value) {
  constexpr int kSteps = 2;
  constexpr double kRejected = std::numeric_limits<double>::infinity();
  if (value < ranges_[delay].low || value > ranges_[delay].high) return kRejected;
  trial.parameters[delay] = value;
  if (!descend_states(trial, kAll, 1) || !descend(trial, kSteps)) return kRejected;
  return cost(trial, run_(trial));
}

}  // namespace eagerx::identification
