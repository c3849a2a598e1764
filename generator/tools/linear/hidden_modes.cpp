#include "generator/tools/linear/hidden_modes.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <complex>

namespace eagerx::gen {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
constexpr double kHidden = 1e-9;         // of the largest number of a row
constexpr double kTermRounding = 1e-12;  // of what numbers of a map consist of

MatrixXd orthonormal(const MatrixXd& columns) {
  if (columns.cols() == 0) return columns;
  const Eigen::HouseholderQR<MatrixXd> qr(columns);
  return qr.householderQ() * MatrixXd::Identity(columns.rows(), columns.cols());
}
/// Orthonormal columns that `m` turns into less than kHidden.
MatrixXd null_space(const MatrixXd& m) {
  const Eigen::JacobiSVD<MatrixXd> svd(m, Eigen::ComputeFullV);
  const Index rank = (svd.singularValues().array() > kHidden).count();
  return svd.matrixV().rightCols(m.cols() - rank);
}

/// Scales of the states with which the rows and columns of a map have about the same size: Osborne,
/// On pre-conditioning of matrices, J. ACM 7 (1960), 338-345.
VectorXd balance_of(MatrixXd map) {
  constexpr int kRounds = 20;
  VectorXd scale = VectorXd::Ones(map.rows());
  map.diagonal().setZero();
  for (int round = 0; round < kRounds; ++round) {
    for (Index i = 0; i < map.rows(); ++i) {
      const double row = map.row(i).norm(), column = map.col(i).norm();
      if (row == 0.0 || column == 0.0) continue;
      const double factor = std::exp2(std::round(0.5 * std::log2(row / column)));
      map.col(i) *= factor;
      map.row(i) /= factor;
      scale[i] *= factor;
    }
  }
  return scale;
}

/// From the state before the first phase, in units of `scale`: what costs and what is received, in
/// all phases. The rows have a largest number of 1; what is rounding of its terms counts as 0.
MatrixXd seen_from_first(const PeriodicProblem& problem, const VectorXd& scale) {
  const Index n = problem.front().cost.a.rows();
  MatrixXd of_x = scale.asDiagonal(), terms = of_x, rows(0, n);
  for (const PeriodicPhase& phase : problem) {
    MatrixXd seen(n + phase.c.rows(), n);
    seen << phase.cost.q, phase.c;
    const MatrixXd here = seen * of_x, least = kTermRounding * (seen.cwiseAbs() * terms);
    rows.conservativeResize(rows.rows() + here.rows(), Eigen::NoChange);
    rows.bottomRows(here.rows()) = (here.array().abs() > least.array()).select(here, 0.0);
    of_x = (phase.cost.a * of_x).eval();
    terms = (phase.cost.a.cwiseAbs() * terms).eval();
  }
  for (Index i = 0; i < rows.rows(); ++i) {
    const double most = rows.row(i).cwiseAbs().maxCoeff();
    if (most > 0.0) rows.row(i) /= most;
  }
  return rows;
}

/// How many of the poles, sorted by their distance from 1, are integrators. `size`: of the map.
Index integrators_among(const std::vector<std::complex<double>>& poles, double size) {
  constexpr double kMean = 1e-8, kScatter = 10.0;
  std::complex<double> sum = 0.0;
  Index count = 0;
  for (std::size_t i = 0; i < poles.size(); ++i) {
    const auto k = static_cast<double>(i + 1);
    sum += poles[i] - 1.0;
    const double scatter = kScatter * std::pow(kTermRounding * std::max(1.0, size), 1.0 / k);
    const bool is_near = std::abs(poles[i] - 1.0) < std::max(kOnCircle, scatter);
    if (is_near && std::abs(sum) / k < (i == 0 ? kOnCircle : kMean))
      count = static_cast<Index>(i + 1);
  }
  return count;
}

/// Corrects an invariant subspace whose poles are all 1: those of T22·X - X·T11 = -E, of the map in
/// the basis of it and what is orthogonal to it. T11 - I is nilpotent, so a few rounds solve it.
MatrixXd refined(const MatrixXd& map, const MatrixXd& space) {
  const Index n = map.rows(), k = space.cols();
  if (k == 0 || k == n) return space;
  const Eigen::HouseholderQR<MatrixXd> qr(space);
  const MatrixXd basis = qr.householderQ() * MatrixXd::Identity(n, n);
  const MatrixXd in_basis = basis.transpose() * map * basis;
  const MatrixXd nilpotent = in_basis.topLeftCorner(k, k) - MatrixXd::Identity(k, k);
  const MatrixXd error = in_basis.bottomLeftCorner(n - k, k);
  const Eigen::PartialPivLU<MatrixXd> rest(in_basis.bottomRightCorner(n - k, n - k) -
                                           MatrixXd::Identity(n - k, n - k));
  MatrixXd x = MatrixXd::Zero(n - k, k);
  for (Index round = 0; round <= k; ++round) x = rest.solve(x * nilpotent - error);
  return orthonormal(basis.leftCols(k) + basis.rightCols(n - k) * x);
}

/// The modes of a map that neither grow nor decay.
MatrixXd still_modes(const MatrixXd& map) {
  const Index n = map.rows();
  const Eigen::EigenSolver<MatrixXd> modes(map);
  std::vector<Index> order(static_cast<std::size_t>(n));
  for (Index k = 0; k < n; ++k) order[static_cast<std::size_t>(k)] = k;
  std::ranges::stable_sort(order, {},
                           [&](Index k) { return std::abs(modes.eigenvalues()[k] - 1.0); });
  std::vector<std::complex<double>> poles;
  for (const Index k : order) poles.push_back(modes.eigenvalues()[k]);
  const Index integrators = integrators_among(poles, map.norm());
  MatrixXd chain = MatrixXd::Identity(n, n);
  for (Index i = 0; i < integrators; ++i) chain = (chain * (map - MatrixXd::Identity(n, n))).eval();
  const Eigen::JacobiSVD<MatrixXd> svd(chain, Eigen::ComputeFullV);
  MatrixXd still = refined(map, svd.matrixV().rightCols(integrators));
  for (std::size_t i = static_cast<std::size_t>(integrators); i < order.size(); ++i) {
    if (std::abs(std::abs(poles[i]) - 1.0) > kOnCircle) continue;
    const VectorXcd mode = modes.eigenvectors().col(order[i]);
    still.conservativeResize(Eigen::NoChange, still.cols() + 1);
    // Of a conjugated pair, both parts.
    if (poles[i].imag() < 0.0)
      still.rightCols(1) = mode.imag();
    else
      still.rightCols(1) = mode.real();
  }
  return orthonormal(still);
}

}  // namespace

MatrixXd hidden_modes(const PeriodicProblem& problem) {
  const MatrixXd whole = map_of(problem);
  const VectorXd scale = balance_of(whole);
  const MatrixXd map = scale.cwiseInverse().asDiagonal() * whole * scale.asDiagonal();
  MatrixXd hidden = still_modes(map);
  if (hidden.cols() == 0) return hidden;
  hidden = (hidden * null_space(seen_from_first(problem, scale) * hidden)).eval();
  while (hidden.cols() > 0) {  // each round keeps all of them, or fewer
    const MatrixXd next = map * hidden;
    const MatrixXd inside = null_space(next - hidden * (hidden.transpose() * next));
    if (inside.cols() == hidden.cols()) break;
    hidden = (hidden * inside).eval();
  }
  return orthonormal(scale.asDiagonal() * hidden);
}

std::vector<Index> settle_hidden(PeriodicProblem& problem) {
  const MatrixXd hidden = hidden_modes(problem);
  if (hidden.cols() == 0) return {};
  MatrixXd& a = problem.front().cost.a;
  a -= (a * hidden * hidden.transpose()).eval();
  const Eigen::ColPivHouseholderQR<MatrixXd> order(hidden.transpose());
  std::vector<Index> states;
  for (Index k = 0; k < hidden.cols(); ++k) states.push_back(order.colsPermutation().indices()[k]);
  return states;
}

}  // namespace eagerx::gen
