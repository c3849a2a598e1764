#include "generator/tools/linear/riccati.hpp"

#include <Eigen/Eigenvalues>

namespace eagerx::gen {
namespace {

using Eigen::MatrixXd;
constexpr int kMostDoublings = 60;
constexpr double kRounding = 1e-15;

/// The factors that give each state the same size in P: those of states that cost much are small.
Eigen::VectorXd scales_of(const MatrixXd& p) {
  const double least = 1e-12 * p.diagonal().cwiseAbs().maxCoeff();
  return p.diagonal().cwiseAbs().cwiseMax(least).cwiseSqrt().cwiseInverse();
}

/// P by doubling of the problem without S; its limit costs least, but need not be stabilizing.
std::optional<MatrixXd> doubled(MatrixXd a, const MatrixXd& b, MatrixXd h, const MatrixXd& r) {
  const Eigen::Index n = a.rows();
  MatrixXd g = b * r.ldlt().solve(b.transpose());
  for (int k = 0; k < kMostDoublings; ++k) {
    const Eigen::PartialPivLU<MatrixXd> w(MatrixXd::Identity(n, n) + g * h);
    const MatrixXd wa = w.solve(a), wg = w.solve(g);
    const MatrixXd step = a.transpose() * h * wa;
    g += a * wg * a.transpose();
    h += step;
    a = a * wa;
    g = (0.5 * (g + g.transpose())).eval();
    h = (0.5 * (h + h.transpose())).eval();
    if (!h.allFinite() || !a.allFinite() || !g.allFinite()) return std::nullopt;
    if (step.norm() <= kRounding * h.norm()) return h;
  }
  return std::nullopt;
}

MatrixXd gain_of(const LinearQuadratic& of, const MatrixXd& p) {
  const MatrixXd pb = p * of.b;
  return (of.r + of.b.transpose() * pb).ldlt().solve(pb.transpose() * of.a + of.s.transpose());
}

/// The cost of u = -K·x.
MatrixXd cost_of(const LinearQuadratic& of, const MatrixXd& gain) {
  const MatrixXd closed = of.a - of.b * gain, sk = of.s * gain;
  return solve_stein(closed.transpose(),
                     of.q + gain.transpose() * of.r * gain - sk - sk.transpose());
}

/// In states of about the same size, where the doubling loses least.
LinearQuadratic scaled(const LinearQuadratic& of, const Eigen::VectorXd& scale) {
  const auto t = scale.asDiagonal();
  const auto back = scale.cwiseInverse().asDiagonal();
  return {back * of.a * t, back * of.b, t * of.q * t, of.r, t * of.s};
}

}  // namespace

double radius_of(const MatrixXd& a) {
  return a.size() == 0 ? 0.0 : a.eigenvalues().cwiseAbs().maxCoeff();
}

MatrixXd solve_stein(const MatrixXd& a, const MatrixXd& q) {
  MatrixXd power = a, x = q;
  for (int k = 0; k < kMostDoublings; ++k) {
    const MatrixXd step = power * x * power.transpose();
    x += step;
    if (!x.allFinite() || step.norm() <= kRounding * x.norm()) break;
    power = (power * power).eval();
  }
  return 0.5 * (x + x.transpose());
}

std::optional<Regulator> solve_riccati(const LinearQuadratic& problem) {
  constexpr int kRounds = 3;
  LinearQuadratic at = problem;
  Eigen::VectorXd scale = Eigen::VectorXd::Ones(problem.a.rows());
  std::optional<MatrixXd> p;
  // Its diagonal is not known before it is solved: the second round has it.
  for (int round = 0; round < 2; ++round) {
    const MatrixXd rs = at.r.ldlt().solve(at.s.transpose());
    p = doubled(at.a - at.b * rs, at.b, at.q - at.s * rs, at.r);
    if (!p) return std::nullopt;
    if (round == 1 || p->size() == 0) break;
    scale = scales_of(*p);
    at = scaled(problem, scale);
  }
  Regulator result;
  result.gain = gain_of(at, *p);
  for (int round = 0; round < kRounds; ++round) {
    result.spectral_radius = radius_of(at.a - at.b * result.gain);
    if (!(result.spectral_radius < 1.0)) return std::nullopt;
    *p = cost_of(at, result.gain);
    result.gain = gain_of(at, *p);
  }
  const auto back = scale.cwiseInverse().asDiagonal();
  result.p = back * *p * back;
  result.gain = (result.gain * back).eval();
  return result;
}

}  // namespace eagerx::gen
