#include "generator/tools/linear/periodic.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "generator/tools/linear/node_plant.hpp"
#include "generator/tools/linear/stabilize.hpp"

namespace eagerx::gen {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd symmetric(const MatrixXd& x) {
  return 0.5 * (x + x.transpose());
}

/// One step of all phases, with the inputs of all.
LinearQuadratic lifted(const PeriodicProblem& problem) {
  const Index n = problem.front().cost.a.rows(), m = problem.front().cost.b.cols();
  const Index all = m * static_cast<Index>(problem.size());
  // x of the phase from the first x and all inputs.
  MatrixXd of_x = MatrixXd::Identity(n, n), of_u = MatrixXd::Zero(n, all);
  LinearQuadratic whole;
  whole.q = MatrixXd::Zero(n, n);
  whole.s = MatrixXd::Zero(n, all);
  whole.r = MatrixXd::Zero(all, all);
  Index at = 0;
  for (const PeriodicPhase& phase : problem) {
    const LinearQuadratic& here = phase.cost;
    const MatrixXd qx = here.q * of_x, qu = here.q * of_u;
    whole.q += of_x.transpose() * qx;
    whole.s += of_x.transpose() * qu;
    whole.r += of_u.transpose() * qu;
    whole.s.middleCols(at, m) += of_x.transpose() * here.s;
    const MatrixXd cross = of_u.transpose() * here.s;
    whole.r.middleCols(at, m) += cross;
    whole.r.middleRows(at, m) += cross.transpose();
    whole.r.block(at, at, m, m) += here.r;
    of_x = (here.a * of_x).eval();
    of_u = (here.a * of_u).eval();
    of_u.middleCols(at, m) += here.b;
    at += m;
  }
  whole.a = of_x;
  whole.b = of_u;
  whole.r = symmetric(whole.r);
  whole.q = symmetric(whole.q);
  return whole;
}

/// What the recursions of the cost and of the covariance come to after a hyperperiod.
struct Closed {
  std::vector<MatrixXd> maps;  // of the phases
  double radius = 0.0;
};

std::vector<MatrixXd> costs(const PeriodicProblem& problem, const MatrixXd& gain,
                            const Closed& closed) {
  const std::size_t phases = problem.size();
  const auto stage = [&](std::size_t i) {
    const LinearQuadratic& here = problem[i].cost;
    const MatrixXd f = -gain * problem[i].c, sf = here.s * f;
    return MatrixXd(here.q + sf + sf.transpose() + f.transpose() * here.r * f);
  };
  const Index n = problem.front().cost.a.rows();
  MatrixXd sum = MatrixXd::Zero(n, n);
  for (std::size_t i = phases; i-- > 0;)
    sum = (stage(i) + closed.maps[i].transpose() * sum * closed.maps[i]).eval();
  std::vector<MatrixXd> p(phases + 1);
  p[0] = solve_stein(monodromy(closed.maps).transpose(), sum);
  p[phases] = p[0];
  for (std::size_t i = phases; i-- > 1;)
    p[i] = symmetric(stage(i) + closed.maps[i].transpose() * p[i + 1] * closed.maps[i]);
  return p;
}

/// BFGS with a line that halves its steps: Nocedal, Wright: Numerical Optimization, 2006, 6.1.
class Descent {
 public:
  explicit Descent(const PeriodicProblem& problem) : problem_(problem) {}

  MatrixXd from(MatrixXd gain, int rounds) const {
    OutputFeedback now = output_feedback(problem_, gain);
    const Index size = gain.size();
    MatrixXd inverse = MatrixXd::Identity(size, size);
    for (int round = 0; round < rounds; ++round) {
      const VectorXd slope = now.slope.reshaped();
      if (!(slope.norm() * (1.0 + gain.norm()) > kFlat * now.cost)) break;
      VectorXd way = -inverse * slope;
      if (!(way.dot(slope) < 0.0)) {
        inverse.setIdentity();
        way = -slope;
      }
      if (round == 0) way *= std::min(1.0, kFirst * (1.0 + gain.norm()) / way.norm());
      const auto then = step(gain, now, way);
      if (!then) break;
      const VectorXd moved = (then->gain - gain).reshaped();
      const VectorXd bent = VectorXd(then->at.slope.reshaped()) - slope;
      learn(inverse, moved, bent, round == 0);
      gain = then->gain;
      now = then->at;
    }
    return gain;
  }

 private:
  static constexpr double kFlat = 1e-11, kFirst = 0.1;
  struct Step {
    MatrixXd gain;
    OutputFeedback at;
  };

  [[nodiscard]] std::optional<Step> step(const MatrixXd& gain, const OutputFeedback& now,
                                         const VectorXd& way) const {
    constexpr double kSlope = 1e-4;
    const double fall = way.dot(VectorXd(now.slope.reshaped()));
    double length = 1.0;
    for (int halvings = 0; halvings < 50; ++halvings, length *= 0.5) {
      Step next;
      next.gain = gain + length * MatrixXd(way.reshaped(gain.rows(), gain.cols()));
      next.at = output_feedback(problem_, next.gain);
      if (next.at.spectral_radius < 1.0 && next.at.cost <= now.cost + kSlope * length * fall)
        return next;
    }
    return std::nullopt;
  }
  static void learn(MatrixXd& inverse, const VectorXd& moved, const VectorXd& bent, bool is_first) {
    const double curvature = moved.dot(bent);
    if (!(curvature > 1e-14 * moved.norm() * bent.norm())) return;
    if (is_first) inverse *= curvature / bent.squaredNorm();
    const VectorXd hb = inverse * bent;
    inverse += (1.0 + bent.dot(hb) / curvature) / curvature * moved * moved.transpose() -
               (hb * moved.transpose() + moved * hb.transpose()) / curvature;
  }

  const PeriodicProblem& problem_;
};

}  // namespace

MatrixXd map_of(const PeriodicProblem& problem) {
  std::vector<MatrixXd> maps;
  for (const PeriodicPhase& phase : problem) maps.push_back(phase.cost.a);
  return monodromy(maps);
}

std::optional<PeriodicRegulator> solve_periodic(const PeriodicProblem& problem) {
  const auto whole = solve_riccati(lifted(problem));
  if (!whole) return std::nullopt;
  const std::size_t phases = problem.size();
  PeriodicRegulator result;
  result.p.resize(phases + 1);
  result.gain.resize(phases);
  result.p[phases] = whole->p;
  for (std::size_t i = phases; i-- > 0;) {
    const LinearQuadratic& here = problem[i].cost;
    const MatrixXd pb = result.p[i + 1] * here.b;
    const MatrixXd cross = pb.transpose() * here.a + here.s.transpose();
    result.gain[i] = (here.r + here.b.transpose() * pb).ldlt().solve(cross);
    result.p[i] = symmetric(here.a.transpose() * result.p[i + 1] * here.a + here.q -
                            cross.transpose() * result.gain[i]);
  }
  return result;
}

std::vector<MatrixXd> covariances(const PeriodicProblem& problem,
                                  const std::vector<MatrixXd>& closed) {
  const std::size_t phases = problem.size();
  const Index n = problem.front().cost.a.rows();
  MatrixXd sum = MatrixXd::Zero(n, n);
  const auto next = [&](std::size_t i, const MatrixXd& before) {
    const MatrixXd& b = problem[i].cost.b;
    return symmetric(closed[i] * before * closed[i].transpose() + b * b.transpose());
  };
  for (std::size_t i = 0; i < phases; ++i) sum = next(i, sum);
  std::vector<MatrixXd> result(phases);
  result[0] = solve_stein(monodromy(closed), sum);
  for (std::size_t i = 0; i + 1 < phases; ++i) result[i + 1] = next(i, result[i]);
  return result;
}

OutputFeedback output_feedback(const PeriodicProblem& problem, const MatrixXd& gain) {
  OutputFeedback result;
  Closed closed;
  for (const PeriodicPhase& phase : problem)
    closed.maps.emplace_back(phase.cost.a - phase.cost.b * gain * phase.c);
  result.spectral_radius = radius_of(monodromy(closed.maps));
  if (!(result.spectral_radius < 1.0)) return result;
  const std::vector<MatrixXd> p = costs(problem, gain, closed);
  const std::vector<MatrixXd> covariance = covariances(problem, closed.maps);
  result.slope = MatrixXd::Zero(gain.rows(), gain.cols());
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const LinearQuadratic& here = problem[i].cost;
    result.cost += (here.b.transpose() * p[i + 1] * here.b).trace();
    const MatrixXd e = here.r * gain * problem[i].c - here.s.transpose() -
                       here.b.transpose() * p[i + 1] * closed.maps[i];
    result.slope += 2.0 * e * covariance[i] * problem[i].c.transpose();
  }
  return result;
}

std::optional<MatrixXd> least_output_feedback(const PeriodicProblem& problem,
                                              const std::vector<MatrixXd>& starts) {
  constexpr int kRounds = 500;
  std::optional<MatrixXd> best;
  double least = std::numeric_limits<double>::infinity();
  for (MatrixXd& stable : stabilizing_gains(problem, starts)) {
    MatrixXd gain = Descent(problem).from(std::move(stable), kRounds);
    const double cost = output_feedback(problem, gain).cost;
    if (!(cost < least)) continue;
    least = cost;
    best = std::move(gain);
  }
  return best;
}

}  // namespace eagerx::gen
