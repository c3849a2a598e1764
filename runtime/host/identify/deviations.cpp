// How certain the parameters of a fit are.
#include <algorithm>
#include <cmath>
#include <runtime/host/identify/least_squares.hpp>
#include <runtime/host/identify/matrix.hpp>

namespace eagerx::identification {
namespace {

constexpr double kWithin = 3.0;  // deviations: to here a profile is followed

/// row · matrix · rowᵀ
double quadratic(const Matrix& matrix, const std::vector<double>& row) {
  double sum = 0.0;
  for (std::size_t a = 0; a < row.size(); ++a) {
    for (std::size_t b = 0; b < row.size(); ++b) sum += row[a] * matrix(a, b) * row[b];
  }
  return sum;
}

/// The first `n` rows and columns, and what the range says: one in units of half of it.
Matrix with_range(const Matrix& whole, std::size_t n) {
  Matrix part(n, n);
  for (std::size_t p = 0; p < n; ++p) {
    for (std::size_t q = 0; q < n; ++q) part(p, q) = whole(p, q) + (p == q ? 1.0 : 0.0);
  }
  return part;
}

std::vector<double> unit(std::size_t n, std::size_t p) {
  std::vector<double> row(n, 0.0);
  row[p] = 1.0;
  return row;
}

/// A curvature [n, n] that is not below zero in any direction, whatever noise there is in it, as
/// seen with the metric of `information`.
Matrix raised(const Matrix& curvature, const Matrix& information, std::size_t n) {
  Matrix lower = information;
  Matrix seen(n, n);
  if (!factor(lower, n)) return information;
  for (std::size_t p = 0; p < n; ++p) {
    std::vector<double> column(n);
    for (std::size_t a = 0; a < n; ++a) column[a] = (curvature(a, p) + curvature(p, a)) / 2;
    solve_lower(lower, n, column);
    for (std::size_t a = 0; a < n; ++a) seen(p, a) = column[a];
  }
  for (std::size_t a = 0; a < n; ++a) {
    std::vector<double> column(n);
    for (std::size_t p = 0; p < n; ++p) column[p] = seen(p, a);
    solve_lower(lower, n, column);
    for (std::size_t p = 0; p < n; ++p) seen(p, a) = column[p];
  }
  const Matrix vectors = diagonalize(seen, n);
  Matrix result(n, n);
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<double> direction(n, 0.0);  // L v
    for (std::size_t a = 0; a < n; ++a) {
      for (std::size_t b = 0; b <= a; ++b) direction[a] += lower(a, b) * vectors(b, i);
    }
    const double value = std::max(seen(i, i), 0.0);
    for (std::size_t p = 0; p < n; ++p) {
      for (std::size_t q = 0; q < n; ++q) result(p, q) += value * direction[p] * direction[q];
    }
  }
  return result;
}

}  // namespace

/// False if the program gives no numbers.
bool LeastSquares::reduce(const Trial& trial, Reduced& reduced) {
  const std::size_t n = unknown_states();
  const std::size_t parameters = ranges_.size();
  const std::vector<double> residuals = run_(trial);
  if (!differentiate(trial, true)) return false;
  Equations equations{Matrix(parameters, parameters), std::vector<double>(parameters, 0.0), {}};
  assemble(equations, residuals, kAll, parameters);
  reduced = {equations.parameters, Matrix(parameters, parameters),
             std::vector<double>(parameters, 0.0)};
  for (auto& segment : equations.segments) {
    for (std::size_t a = 0; a < n; ++a)
      segment.states(a, a) += kTiny * (segment.states(a, a) + 1.0);
    if (!factor(segment.states, n)) continue;
    std::vector<double> score = segment.parameter_gradient;
    for (std::size_t p = 0; p < parameters; ++p) {
      std::vector<double> column(n);
      for (std::size_t a = 0; a < n; ++a) column[a] = segment.mixed(p, a);
      solve(segment.states, n, column);
      for (std::size_t a = 0; a < n; ++a) score[p] -= column[a] * segment.gradient[a];
      for (std::size_t q = 0; q < parameters; ++q) {
        for (std::size_t a = 0; a < n; ++a)
          reduced.information(p, q) -= column[a] * segment.mixed(q, a);
      }
    }
    for (std::size_t p = 0; p < parameters; ++p) {
      reduced.score[p] += score[p];
      for (std::size_t q = 0; q < parameters; ++q) reduced.scatter(p, q) += score[p] * score[q];
    }
  }
  // The parameters were chosen to make the scatter small.
  const auto segments = static_cast<double>(equations.segments.size());
  const double small_sample = segments / std::max(segments - static_cast<double>(parameters), 1.0);
  for (std::size_t p = 0; p < parameters; ++p) {
    for (std::size_t q = 0; q < parameters; ++q) reduced.scatter(p, q) *= small_sample;
  }
  return true;
}

/// Of the cost by the parameters but the delays, with first states fitted again: by differences of
/// the scores over half of a deviation.
Matrix LeastSquares::curvature(const Trial& trial, const Reduced& here) {
  constexpr double kShare = 0.5;
  constexpr double kLeast = 1e-3;  // of half the range: less is float's rounding
  constexpr int kSteps = 2;
  const std::size_t n = first_delay_;
  Matrix result(n, n);
  Matrix factors = with_range(here.information, n);
  if (!factor(factors, n)) return here.information;
  for (std::size_t p = 0; p < n; ++p) {
    std::vector<double> row = unit(n, p);
    solve(factors, n, row);
    const double step = std::clamp(kShare * std::sqrt(row[p]), kLeast, kShare) * half(p);
    std::vector<double> scores[2];
    double values[2];
    for (const std::size_t side : {0U, 1U}) {
      Trial moved = trial;
      moved.parameters[p] = std::clamp(trial.parameters[p] + (side == 0 ? -step : step),
                                       ranges_[p].low, ranges_[p].high);
      values[side] = moved.parameters[p];
      Reduced there = here;
      if (!descend_states(moved, kAll, kSteps) || !reduce(moved, there)) return here.information;
      scores[side] = there.score;
    }
    for (std::size_t q = 0; q < n; ++q)
      result(p, q) = (scores[1][q] - scores[0][q]) / ((values[1] - values[0]) / half(p));
  }
  return raised(result, with_range(here.information, n), n);
}

/// In units of half the ranges.
std::vector<double> LeastSquares::with_delays_held(const Trial& trial, const Reduced& here,
                                                   const Matrix& curvature) const {
  const std::size_t n = first_delay_;
  std::vector<double> result(n, 1.0);
  Matrix factors = with_range(curvature, n);
  if (!factor(factors, n)) return result;
  const Matrix noise = with_range(here.information, n);
  const Matrix scatter = with_range(here.scatter, n);
  // The step that would come next: the descent ends where the rounding of float stops it.
  std::vector<double> left(here.score.begin(), here.score.begin() + static_cast<std::ptrdiff_t>(n));
  for (std::size_t p = 0; p < n; ++p)
    left[p] += (trial.parameters[p] - ranges_[p].low) / half(p) - 1.0;
  solve(factors, n, left);
  for (std::size_t p = 0; p < n; ++p) {
    std::vector<double> row = unit(n, p);
    solve(factors, n, row);  // a row of the inverse
    const double variance = std::max(quadratic(noise, row), quadratic(scatter, row));
    result[p] = std::sqrt(variance + left[p] * left[p]);
  }
  return result;
}

/// Follows the profile of the cost to one side until it is kWithin² higher, or to the end of the
/// range. `guess`: of the deviation.
LeastSquares::Reach LeastSquares::reach(const Trial& trial, std::size_t parameter, double side,
                                        double guess) {
  constexpr int kTries = 10, kSteps = 4;
  constexpr double kNear = 0.1;  // of kWithin
  const double room = side < 0.0 ? trial.parameters[parameter] - ranges_[parameter].low
                                 : ranges_[parameter].high - trial.parameters[parameter];
  Reach result{0.0, std::vector<double>(ranges_.size(), 0.0)};
  if (!(room > 0.0)) return result;
  const double least = cost(trial, run_(trial));
  // Distances: the longest one that is near enough, and how many deviations that is; the shortest
  // one that is too far, if there is one; the next one to try.
  double inside = 0.0, deviations = 0.0, outside = room;
  double distance = std::clamp(kWithin * guess, room / 1e3, room);
  bool is_outside = false;
  is_held_[parameter] = true;
  Trial nearest = trial;
  for (int i = 0; i < kTries && inside < room; ++i) {
    Trial moved = nearest;
    moved.parameters[parameter] = trial.parameters[parameter] + side * distance;
    const bool fits = descend_states(moved, kAll, 1) && descend(moved, kSteps);
    const double far =
        fits ? std::sqrt(std::max(cost(moved, run_(moved)) - least, 0.0)) : 1.0 / kTiny;
    if (far < (1.0 + kNear) * kWithin) {
      inside = distance;
      deviations = far;
      nearest = moved;
      if (far > (1.0 - kNear) * kWithin) break;
    } else {
      outside = distance;
      is_outside = true;
    }
    distance *= kWithin / std::max(far, kTiny);
    if (distance > inside && distance < outside) continue;
    distance = is_outside ? (inside + outside) / 2 : room;
  }
  is_held_[parameter] = false;
  // A flat profile ends where the range does, or at a wall.
  if (deviations > (1.0 - kNear) * kWithin || !is_outside) {
    result.deviation = inside / std::max(deviations, 1.0);
  } else {
    result.deviation = outside / kWithin;
  }
  for (std::size_t p = 0; p < ranges_.size() && inside > 0.0; ++p)
    result.moves[p] =
        (nearest.parameters[p] - trial.parameters[p]) / half(p) * result.deviation / inside;
  return result;
}

std::vector<double> LeastSquares::deviations(const Trial& trial) {
  const std::size_t parameters = ranges_.size();
  std::vector<double> result(parameters);
  for (std::size_t p = 0; p < parameters; ++p) result[p] = half(p);
  Reduced here{Matrix(0, 0), Matrix(0, 0), {}};
  if (!reduce(trial, here)) return result;
  std::vector<double> held = with_delays_held(trial, here, curvature(trial, here));
  Matrix factors = with_range(here.information, parameters);
  if (!factor(factors, parameters)) return result;
  for (std::size_t p = 0; p < first_delay_; ++p) result[p] = held[p] * held[p];
  for (std::size_t d = first_delay_; d < parameters; ++d) {
    std::vector<double> row = unit(parameters, d);
    solve(factors, parameters, row);
    const double guess = std::sqrt(row[d]) * half(d);
    const Reach below = reach(trial, d, -1.0, guess), above = reach(trial, d, 1.0, guess);
    const Reach& longer = below.deviation > above.deviation ? below : above;
    // Correlated errors widen the profile as they widen the sandwich.
    const double more = std::sqrt(std::max(quadratic(here.scatter, row) / row[d], 1.0));
    result[d] = more * longer.deviation;
    for (std::size_t p = 0; p < first_delay_; ++p)
      result[p] += more * more * longer.moves[p] * longer.moves[p];
  }
  for (std::size_t p = 0; p < first_delay_; ++p) result[p] = half(p) * std::sqrt(result[p]);
  return result;
}

}  // namespace eagerx::identification
