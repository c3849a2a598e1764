#include "generator/tools/linear/stabilize.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <random>

namespace eagerx::gen {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
struct Mode {
  std::complex<double> z;
  VectorXcd vector;
};
/// The eigenvalue with the largest |z|, or that nearest to `to`.
Mode mode_of(const MatrixXd& map, const std::complex<double>* to) {
  const Eigen::EigenSolver<MatrixXd> modes(map);
  Index best = 0;
  if (to != nullptr)
    (modes.eigenvalues().array() - *to).abs().minCoeff(&best);
  else
    modes.eigenvalues().cwiseAbs().maxCoeff(&best);
  return {modes.eigenvalues()[best], modes.eigenvectors().col(best)};
}

/// BFGS on log |z| of the slowest pole.
class PoleDescent {
 public:
  explicit PoleDescent(const PeriodicProblem& problem) : problem_(problem) {
    constexpr double kOfEigenvalues = 50.0;  // n³, with vectors, of a map and its transpose
    const auto n = static_cast<double>(problem.front().cost.a.rows());
    const double each = (static_cast<double>(problem.size()) + kOfEigenvalues) * n * n * n;
    left_ = static_cast<int>(std::max(kFewestPoles, kMostWork / std::max(each, 1e4)));
  }

  /// Nothing if the descent ends at a loop that is not stable, or all work is done.
  std::optional<MatrixXd> from(MatrixXd gain) {
    SlowestPole now = pole(gain);
    const Index size = gain.size();
    MatrixXd inverse = MatrixXd::Identity(size, size);
    for (int round = 0; round < kRounds && !(now.log_radius < kStable); ++round) {
      const VectorXd slope = now.slope.reshaped();
      VectorXd step = -inverse * slope;
      if (!(step.dot(slope) < 0.0) || !step.allFinite()) {
        inverse.setIdentity();
        step = -slope;
      }
      // The first step has no curvature yet: a tenth of the gains.
      if (round == 0 && step.norm() > 0.0) step *= (1.0 + gain.norm()) / (10.0 * step.norm());
      const auto next = line(gain, now, step);
      if (!next) return std::nullopt;
      learn(inverse, VectorXd((next->gain - gain).reshaped()),
            VectorXd(next->at.slope.reshaped()) - slope);
      gain = next->gain;
      now = next->at;
    }
    return now.log_radius < kStable ? std::optional(gain) : std::nullopt;
  }

 private:
  static constexpr int kRounds = 150;
  static constexpr double kStable = -1e-9;     // log |z|: a loop that rests
  static constexpr double kMostWork = 4e9;     // multiplications of all descents, some seconds
  static constexpr double kFewestPoles = 1e3;  // of gains, however large the problem is
  struct Point {
    MatrixXd gain;
    SlowestPole at;
  };
  SlowestPole pole(const MatrixXd& gain) {
    --left_;
    return slowest_pole(problem_, gain);
  }

  /// Wolfe's weak conditions by bisection and doubling: Lewis and Overton, algorithm 2.6. Without
  /// the second one after all rounds, the best point with the first one.
  std::optional<Point> line(const MatrixXd& gain, const SlowestPole& now, const VectorXd& step) {
    constexpr int kTries = 30;
    constexpr double kFall = 1e-4, kSlope = 0.5;
    const double slope = step.dot(VectorXd(now.slope.reshaped()));
    double low = 0.0, high = std::numeric_limits<double>::infinity(), length = 1.0;
    std::optional<Point> best;
    for (int tries = 0; tries < kTries && left_ > 0; ++tries) {
      Point next;
      next.gain = gain + length * MatrixXd(step.reshaped(gain.rows(), gain.cols()));
      next.at = pole(next.gain);
      if (!(next.at.log_radius <= now.log_radius + kFall * length * slope)) {
        high = length;
      } else {
        const double there = step.dot(VectorXd(next.at.slope.reshaped()));
        best = std::move(next);
        if (there >= kSlope * slope || best->at.log_radius < kStable) return best;
        low = length;
      }
      length = std::isfinite(high) ? 0.5 * (low + high) : 2.0 * low;
    }
    return best;
  }
  static void learn(MatrixXd& inverse, const VectorXd& moved, const VectorXd& bent) {
    const double curvature = moved.dot(bent);
    if (!(curvature > 1e-14 * moved.norm() * bent.norm())) return;
    const VectorXd hb = inverse * bent;
    inverse += (1.0 + bent.dot(hb) / curvature) / curvature * moved * moved.transpose() -
               (hb * moved.transpose() + moved * hb.transpose()) / curvature;
  }

  const PeriodicProblem& problem_;
  int left_ = 0;  // gains whose poles may still be computed
};

/// Of a normal distribution, from a generator whose numbers are the same everywhere: the sum of 12
/// uniform numbers.
class Normal {
 public:
  double operator()() {
    constexpr double kRange = 1.0 / 4294967296.0;
    double sum = -6.0;
    for (int i = 0; i < 12; ++i) sum += (static_cast<double>(bits_()) + 0.5) * kRange;
    return sum;
  }

 private:
  std::mt19937 bits_{65};
};

}  // namespace

SlowestPole slowest_pole(const PeriodicProblem& problem, const MatrixXd& gain) {
  const std::size_t phases = problem.size();
  const Index n = problem.front().cost.a.rows();
  std::vector<MatrixXd> maps;
  for (const PeriodicPhase& phase : problem)
    maps.emplace_back(phase.cost.a - phase.cost.b * gain * phase.c);
  MatrixXd whole = MatrixXd::Identity(n, n);
  for (const MatrixXd& map : maps) whole = (map * whole).eval();
  SlowestPole result;
  result.slope = MatrixXd::Zero(gain.rows(), gain.cols());
  result.log_radius = std::numeric_limits<double>::infinity();
  if (!whole.allFinite()) return result;
  const Mode right = mode_of(whole, nullptr), left = mode_of(whole.transpose(), &right.z);
  const double size = std::abs(right.z);
  result.log_radius = std::log(std::max(size, std::numeric_limits<double>::min()));
  // The left vector before each phase, backward: w'·F[N]·…·F[i+1].
  std::vector<VectorXcd> after(phases);
  VectorXcd w = left.vector;
  for (std::size_t i = phases; i-- > 0;) {
    after[i] = w;
    w = (maps[i].transpose() * w).eval();
  }
  const std::complex<double> product =
      (left.vector.transpose() * right.vector)(0, 0) * right.z;  // d log z = w'·dF·v / (w'·v·z)
  if (!(std::abs(product) > 0.0)) return result;
  VectorXcd v = right.vector;
  for (std::size_t i = 0; i < phases; ++i) {
    const VectorXcd sent = problem[i].cost.b.transpose() * after[i], received = problem[i].c * v;
    result.slope -= MatrixXcd(sent * received.transpose() / product).real();
    v = (maps[i] * v).eval();
  }
  return result;
}

std::vector<MatrixXd> stabilizing_gains(const PeriodicProblem& problem,
                                        const std::vector<MatrixXd>& starts) {
  PoleDescent descent(problem);
  std::vector<MatrixXd> found;
  for (const MatrixXd& start : starts) {
    if (auto gain = descent.from(start)) found.push_back(std::move(*gain));
  }
  if (!found.empty() || starts.empty()) return found;
  constexpr int kRandomStarts = 12;
  Normal normal;
  for (int i = 0; i < kRandomStarts && found.empty(); ++i) {
    MatrixXd start = starts.back();
    const double spread = std::exp2(i % 4 - 1) * (1.0 + start.norm());
    for (double& each : start.reshaped()) each += spread * normal();
    if (auto gain = descent.from(start)) found.push_back(std::move(*gain));
  }
  return found;
}

}  // namespace eagerx::gen
