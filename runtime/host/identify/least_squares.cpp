#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <runtime/host/identify/least_squares.hpp>
#include <runtime/host/identify/matrix.hpp>

namespace eagerx::identification {
namespace {

constexpr double kStateStep = 1e-4;  // of a difference, of a state's typical size
constexpr double kFirstDamping = 1e-6, kLess = 0.1, kMore = 10.0;

bool damp_and_factor(Matrix& states, std::size_t n, double damping) {
  double largest = 0.0;
  for (std::size_t a = 0; a < n; ++a) largest = std::max(largest, states(a, a));
  for (std::size_t a = 0; a < n; ++a)
    states(a, a) += damping * states(a, a) + kTiny * (largest + 1.0);
  return factor(states, n);
}

}  // namespace

LeastSquares::LeastSquares(const Experiment& experiment, std::vector<Range> ranges,
                           std::size_t delays, Run run)
    : experiment_(experiment),
      ranges_(std::move(ranges)),
      first_delay_(ranges_.size() - delays),
      is_held_(ranges_.size(), false),
      run_(std::move(run)),
      scale_(experiment.state_scale()),
      deviation_(experiment.group_scale()),
      least_(deviation_.size()),
      counts_(deviation_.size(), true) {
  for (double& scale : scale_) scale = scale > 0.0 ? scale : 1.0;
  for (std::size_t g = 0; g < deviation_.size(); ++g) {
    constexpr double kResolution = 1.2e-7;  // of float, in which most graphs calculate
    deviation_[g] = deviation_[g] > 0.0 ? deviation_[g] : 1.0;
    least_[g] = kResolution * deviation_[g];
  }
  scale_of_groups_ = deviation_;
}

bool LeastSquares::fit(Trial& trial) {
  constexpr std::uint32_t kLonger = 4;
  constexpr int kSteps = 5;
  last_ = run_(trial);
  find_repetitions(last_);
  deviation_ = scale_of_groups_;
  // Unstable objects are far away at the end of a segment if its first state is only guessed.
  std::uint32_t longest = 0;
  for (const Sample& sample : experiment_.samples()) longest = std::max(longest, sample.position);
  for (std::uint32_t window = 1; window <= longest; window *= kLonger) {
    if (!descend_states(trial, window, kSteps)) return false;
  }
  if (!descend_states(trial, kAll, kSteps)) return false;
  start_again(trial, !has_fitted_);
  has_fitted_ = true;
  if (!repeat(trial, 1, kSteps)) return false;
  start_again(trial, false);
  return repeat(trial, 1, kSteps);
}

/// There may be several minima for the first state of a segment: an accelerometer alone does not
/// tell a pendulum's angle from its supplement. A segment goes down once more from where the one
/// before it arrives, as long as that helps, and from some states of typical size; the best counts.
void LeastSquares::start_again(Trial& trial, bool anywhere) {
  constexpr int kPasses = 4, kStarts = 4;
  const std::size_t n = unknown_states();
  for (int i = 0; i < kPasses; ++i) {
    run_(trial);
    Trial tried = trial;
    const std::vector<double>& arrivals = experiment_.arrivals();
    for (std::size_t s = 0; s < tried.states.size(); ++s) {
      if (std::isfinite(arrivals[s])) tried.states[s] = arrivals[s];
    }
    if (!take_better_states(trial, tried)) break;
  }
  for (int i = 1; i <= kStarts && anywhere; ++i) {
    Trial tried = trial;
    for (std::size_t s = 0; s < tried.states.size(); ++s) {
      // Multiples of powers of the golden ratio fill a cube evenly.
      const double turns = i * std::pow(0.6180339887498949, static_cast<double>(s % n + 1));
      tried.states[s] = scale_[s % n] * (2.0 * (turns - std::floor(turns)) - 1.0);
    }
    take_better_states(trial, tried);
  }
}

/// Fits the states of `tried` and takes those of the segments that are better so. False: none is.
bool LeastSquares::take_better_states(Trial& trial, Trial& tried) {
  constexpr int kSteps = 6;
  constexpr double kBetter = 1e-3;  // relative
  const auto n = static_cast<std::ptrdiff_t>(unknown_states());
  const std::vector<double> before = costs(run_(trial), kAll);
  if (!descend_states(tried, kAll, kSteps)) return false;
  const std::vector<double> after = costs(run_(tried), kAll);
  bool better = false;
  for (std::size_t s = 0; s < before.size(); ++s) {
    if (!(after[s] < (1.0 - kBetter) * before[s])) continue;
    better = true;
    const auto first = static_cast<std::ptrdiff_t>(s) * n;
    std::copy_n(tried.states.begin() + first, n, trial.states.begin() + first);
  }
  return better;
}

bool LeastSquares::refine(Trial& trial) {
  constexpr int kRounds = 4;
  constexpr int kSteps = 15;
  start_again(trial, true);
  return repeat(trial, kRounds, kSteps) && settle_delays(trial);
}

/// Standard deviations and fit in turn.
bool LeastSquares::repeat(Trial& trial, int rounds, int steps) {
  for (int i = 0; i < rounds; ++i) {
    weigh(run_(trial));
    if (!descend(trial, steps)) return false;
  }
  last_ = run_(trial);
  weigh(last_);
  return true;
}

void LeastSquares::find_repetitions(const std::vector<double>& residuals) {
  std::vector<std::vector<double>> of_group(counts_.size());
  for (std::size_t i = 0; i < residuals.size(); ++i)
    of_group[experiment_.samples()[i].group].push_back(residuals[i]);
  for (std::size_t g = 0; g < of_group.size(); ++g) {
    const auto end = of_group.begin() + static_cast<std::ptrdiff_t>(g);
    counts_[g] = std::find(of_group.begin(), end, of_group[g]) == end;
  }
}

void LeastSquares::weigh(const std::vector<double>& residuals) {
  std::vector<double> sum(counts_.size(), 0.0), count(counts_.size(), 0.0);
  double all = 0.0;
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    const std::uint32_t group = experiment_.samples()[i].group;
    sum[group] += residuals[i] * residuals[i];
    count[group] += 1.0;
    all += counts_[group] ? 1.0 : 0.0;
  }
  // Unknowns take a part of the noise with them.
  const auto unknowns =
      static_cast<double>(scale_.size() * experiment_.segments() + ranges_.size());
  const double free = std::max(1.0 - unknowns / std::max(all, 1.0), 0.1);
  for (std::size_t g = 0; g < sum.size(); ++g) {
    if (count[g] > 0.0) deviation_[g] = std::max(std::sqrt(sum[g] / (count[g] * free)), least_[g]);
  }
}

std::vector<double> LeastSquares::leftover() const {
  return deviation_;
}

double LeastSquares::deviance() const {
  double sum = 0.0;
  for (const Sample& sample : experiment_.samples()) {
    if (counts_[sample.group]) sum += 2.0 * std::log(deviation_[sample.group]);
  }
  return sum;
}

double LeastSquares::cost(const Trial& trial, const std::vector<double>& residuals) const {
  const std::vector<double> of_segments = costs(residuals, kAll);
  double sum = std::accumulate(of_segments.begin(), of_segments.end(), 0.0);
  for (std::size_t p = 0; p < ranges_.size(); ++p) {  // the range as what was known before
    const double ratio = (trial.parameters[p] - ranges_[p].low) / half(p) - 1.0;
    sum += known_before(p) * ratio * ratio;
  }
  return std::isfinite(sum) ? sum : std::numeric_limits<double>::infinity();
}

bool LeastSquares::differentiate(const Trial& trial, bool with_parameters) {
  const std::size_t n = unknown_states();
  const std::size_t unknowns = n + (with_parameters ? ranges_.size() : 0);
  columns_.assign(unknowns, {});
  for (std::size_t u = 0; u < unknowns; ++u) {
    Trial ahead = trial, behind = trial;
    double width = 2 * kStateStep;
    if (u < n) {
      for (std::size_t s = u; s < trial.states.size(); s += n) {
        ahead.states[s] += kStateStep * scale_[u];
        behind.states[s] -= kStateStep * scale_[u];
      }
    } else {
      const std::size_t p = u - n;
      ahead.parameters[p] =
          std::min(trial.parameters[p] + kParameterStep * half(p), ranges_[p].high);
      behind.parameters[p] =
          std::max(trial.parameters[p] - kParameterStep * half(p), ranges_[p].low);
      width = (ahead.parameters[p] - behind.parameters[p]) / half(p);
    }
    columns_[u] = run_(ahead);
    const std::vector<double>& less = run_(behind);
    if (less.size() != columns_[u].size()) return false;
    for (std::size_t i = 0; i < less.size(); ++i) {
      double& slope = columns_[u][i];
      slope = (slope - less[i]) / width;
      if (!std::isfinite(slope)) slope = 0.0;
    }
  }
  return true;
}

void LeastSquares::assemble(Equations& equations, const std::vector<double>& residuals,
                            std::uint32_t window, std::size_t parameters) const {
  const std::size_t n = unknown_states();
  equations.segments.assign(experiment_.segments(),
                            {Matrix(n, n), Matrix(parameters, n), std::vector<double>(n, 0.0),
                             std::vector<double>(parameters, 0.0)});
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    const Sample& sample = experiment_.samples()[i];
    if (sample.position >= window || !counts_[sample.group]) continue;
    auto& segment = equations.segments[sample.segment];
    const double weight = 1.0 / (deviation_[sample.group] * deviation_[sample.group]);
    for (std::size_t a = 0; a < n; ++a) {
      const double slope = weight * columns_[a][i];
      segment.gradient[a] += slope * residuals[i];
      for (std::size_t b = 0; b < n; ++b) segment.states(a, b) += slope * columns_[b][i];
      for (std::size_t p = 0; p < parameters; ++p)
        segment.mixed(p, a) += slope * columns_[n + p][i];
    }
    for (std::size_t p = 0; p < parameters; ++p) {
      const double slope = weight * columns_[n + p][i];
      segment.parameter_gradient[p] += slope * residuals[i];
      for (std::size_t q = 0; q < parameters; ++q)
        equations.parameters(p, q) += slope * columns_[n + q][i];
    }
  }
  for (const auto& segment : equations.segments) {
    for (std::size_t p = 0; p < parameters; ++p)
      equations.gradient[p] += segment.parameter_gradient[p];
  }
}

Trial LeastSquares::moved(const Trial& trial, const Equations& equations, double damping,
                          bool& solved) const {
  const std::size_t n = unknown_states();
  const std::size_t parameters = equations.gradient.size();
  Matrix reduced = equations.parameters;
  std::vector<double> step = equations.gradient;
  std::vector<Matrix> factors;
  solved = true;
  for (std::size_t p = 0; p < parameters; ++p) {
    step[p] += known_before(p) * ((trial.parameters[p] - ranges_[p].low) / half(p) - 1.0);
    reduced(p, p) += known_before(p) + damping * equations.parameters(p, p);
  }
  for (const auto& segment : equations.segments) {
    Matrix& states = factors.emplace_back(segment.states);
    solved = solved && damp_and_factor(states, n, damping);
    if (!solved) return trial;
    std::vector<double> gradient = segment.gradient;
    solve(states, n, gradient);
    for (std::size_t p = 0; p < parameters; ++p) {
      std::vector<double> column(n);
      for (std::size_t a = 0; a < n; ++a) column[a] = segment.mixed(p, a);
      for (std::size_t a = 0; a < n; ++a) step[p] -= column[a] * gradient[a];
      solve(states, n, column);
      for (std::size_t q = 0; q < parameters; ++q) {
        for (std::size_t a = 0; a < n; ++a) reduced(p, q) -= column[a] * segment.mixed(q, a);
      }
    }
  }
  hold(reduced, step);
  solved = factor(reduced, parameters);
  if (!solved) return trial;
  solve(reduced, parameters, step);
  Trial next = trial;
  std::vector<double> moves(parameters);
  for (std::size_t p = 0; p < parameters; ++p) {
    next.parameters[p] =
        std::clamp(trial.parameters[p] - step[p] * half(p), ranges_[p].low, ranges_[p].high);
    moves[p] = (trial.parameters[p] - next.parameters[p]) / half(p);
  }
  for (std::size_t s = 0; s < equations.segments.size(); ++s) {
    const auto& segment = equations.segments[s];
    std::vector<double> state = segment.gradient;
    for (std::size_t a = 0; a < n; ++a) {
      for (std::size_t p = 0; p < parameters; ++p) state[a] -= segment.mixed(p, a) * moves[p];
    }
    solve(factors[s], n, state);
    for (std::size_t a = 0; a < n; ++a) next.states[s * n + a] -= state[a] * scale_[a];
  }
  return next;
}

/// Equations that leave each held parameter where it is.
void LeastSquares::hold(Matrix& equations, std::vector<double>& step) const {
  for (std::size_t p = 0; p < is_held_.size(); ++p) {
    if (!is_held_[p]) continue;
    for (std::size_t q = 0; q < is_held_.size(); ++q) equations(p, q) = equations(q, p) = 0.0;
    equations(p, p) = 1.0;
    step[p] = 0.0;
  }
}

/// The cost of each segment.
std::vector<double> LeastSquares::costs(const std::vector<double>& residuals,
                                        std::uint32_t window) const {
  std::vector<double> sums(experiment_.segments(), 0.0);
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    const Sample& sample = experiment_.samples()[i];
    if (sample.position >= window || !counts_[sample.group]) continue;
    const double ratio = residuals[i] / deviation_[sample.group];
    sums[sample.segment] += ratio * ratio;
  }
  for (double& sum : sums) {
    if (!std::isfinite(sum)) sum = std::numeric_limits<double>::infinity();
  }
  return sums;
}

/// With parameters that stay, segments have nothing to do with each other: each one has its own
/// damping, and takes the steps that are good for it.
bool LeastSquares::descend_states(Trial& trial, std::uint32_t window, int iterations) {
  constexpr int kTries = 6;
  const std::size_t n = unknown_states();
  const std::size_t segments = experiment_.segments();
  std::vector<double> damping(segments, kFirstDamping);
  std::vector<double> residuals = run_(trial);
  std::vector<double> before = costs(residuals, window);
  if (!std::isfinite(std::accumulate(before.begin(), before.end(), 0.0))) return false;
  for (int i = 0; i < iterations; ++i) {
    if (!differentiate(trial, false)) return false;
    Equations equations{Matrix(0, 0), {}, {}};
    assemble(equations, residuals, window, 0);
    std::vector<bool> better(segments, false);
    const double all = std::accumulate(before.begin(), before.end(), 0.0);
    for (int k = 0; k < kTries; ++k) {
      Trial next = trial;
      for (std::size_t s = 0; s < segments; ++s) {
        if (!better[s]) move_state(next, equations.segments[s], s, damping[s]);
      }
      const std::vector<double> after = costs(run_(next), window);
      bool done = true;
      for (std::size_t s = 0; s < segments; ++s) {
        if (better[s]) continue;
        better[s] = after[s] < before[s];
        damping[s] *= better[s] ? kLess : kMore;
        done = done && better[s];
        if (!better[s]) continue;
        before[s] = after[s];
        std::copy_n(next.states.begin() + static_cast<std::ptrdiff_t>(s * n), n,
                    trial.states.begin() + static_cast<std::ptrdiff_t>(s * n));
      }
      if (done) break;
    }
    residuals = run_(trial);
    if (all - std::accumulate(before.begin(), before.end(), 0.0) <= kDone * all) break;
  }
  return true;
}

/// Its first state by Gauss' and Newton's step.
void LeastSquares::move_state(Trial& trial, const Equations::Segment& segment, std::size_t index,
                              double damping) const {
  const std::size_t n = unknown_states();
  Matrix states = segment.states;
  if (!damp_and_factor(states, n, damping)) return;
  std::vector<double> step = segment.gradient;
  solve(states, n, step);
  for (std::size_t a = 0; a < n; ++a) trial.states[index * n + a] -= step[a] * scale_[a];
}

bool LeastSquares::descend(Trial& trial, int iterations) {
  constexpr double kMostDamping = 1e8;
  const std::size_t parameters = ranges_.size();
  double damping = kFirstDamping;
  std::vector<double> residuals = run_(trial);
  double before = cost(trial, residuals);
  if (!std::isfinite(before)) return false;
  for (int i = 0; i < iterations; ++i) {
    if (!differentiate(trial, true)) return false;
    Equations equations{Matrix(parameters, parameters), std::vector<double>(parameters, 0.0), {}};
    assemble(equations, residuals, kAll, parameters);
    bool better = false;
    double after = before;
    for (; !better && damping < kMostDamping; damping *= better ? kLess : kMore) {
      bool solved = false;
      const Trial next = moved(trial, equations, damping, solved);
      if (!solved) continue;
      const std::vector<double>& tried = run_(next);
      after = cost(next, tried);
      better = after < before;
      if (!better) continue;
      trial = next;
      residuals = tried;
    }
    if (!better || before - after < kDone * before) break;
    before = after;
  }
  return true;
}

}  // namespace eagerx::identification
