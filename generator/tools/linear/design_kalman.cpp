// The gain of an observer, and the covariances of a Kalman filter.
#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "generator/support/diagnostics/join.hpp"
#include "generator/tools/linear/design.hpp"
#include "generator/tools/linear/node_plant.hpp"
#include "generator/tools/linear/riccati.hpp"

namespace eagerx::gen {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

MatrixXd matrix(const std::vector<double>& rows, std::size_t height) {
  const auto h = static_cast<Index>(height);
  const Index w = h == 0 ? 0 : static_cast<Index>(rows.size()) / h;
  return Eigen::Map<const RowMajor>(rows.data(), h, w);
}
std::vector<double> row_after_row(const MatrixXd& matrix) {
  const RowMajor rows = matrix;
  return {rows.data(), rows.data() + rows.size()};
}

/// x + squares on the diagonal.
MatrixXd noise_of(const KalmanRequest& request) {
  const auto n = static_cast<Index>(request.model.order);
  MatrixXd q = MatrixXd::Zero(n, n);
  for (std::size_t i = 0; i < request.process.size(); ++i)
    q(static_cast<Index>(i), static_cast<Index>(i)) += request.process[i] * request.process[i];
  if (request.input.empty()) return q;
  const MatrixXd b = matrix(request.model.b, request.model.order);
  for (Index i = 0; i < b.cols(); ++i) {
    const double deviation = request.input[static_cast<std::size_t>(i)];
    q += deviation * deviation * b.col(i) * b.col(i).transpose();
  }
  return q;
}

std::string name_of(const KalmanRequest& request, Index i) {
  const auto at = static_cast<std::size_t>(i);
  return at < request.state.size() ? request.state[at] : fmt::format("x[{}]", i);
}

/// Which state has no steady error.
void explain(const KalmanRequest& request, const MatrixXd& a, KalmanDesign& result) {
  const Eigen::EigenSolver<MatrixXd> modes(a.transpose());
  Index worst = 0, state = 0;
  modes.eigenvalues().cwiseAbs().maxCoeff(&worst);
  modes.eigenvectors().col(worst).cwiseAbs().maxCoeff(&state);
  result.problem = fmt::format(
      "no gain is steady and stable: a mode with |z| = {:.6g}, of `{}` above all, is either not in "
      "what is measured, or has no noise",
      std::abs(modes.eigenvalues()[worst]), name_of(request, state));
  result.help = "measure it, or write its noise: `--process`";
}

/// Whether the phases are one map, but for rounding.
bool is_same(const PlantPhase& one, const PlantPhase& other) {
  constexpr double kRounding = 1e-9;
  const auto differ = [](const MatrixXd& a, const MatrixXd& b) {
    return (a - b).norm() > kRounding * (a.norm() + b.norm());
  };
  return !differ(one.a, other.a) && !differ(one.b, other.b) && !differ(one.c, other.c);
}

/// The rows of an input of the node.
MatrixXd rows_of(const NodePlant& plant, const MatrixXd& c, const std::string& input) {
  std::vector<Index> at;
  for (std::size_t i = 0; i < plant.received.size(); ++i) {
    if (plant.received[i].input == input) at.push_back(static_cast<Index>(i));
  }
  MatrixXd result(static_cast<Index>(at.size()), c.cols());
  for (std::size_t i = 0; i < at.size(); ++i) result.row(static_cast<Index>(i)) = c.row(at[i]);
  return result;
}

/// What was sent after a tick must be what the filter receives at the next one.
bool receives_what_acts(const NodePlant& plant, const PlantPhase& phase, const PlantPhase& next) {
  const MatrixXd u = rows_of(plant, next.c, "u");
  if (u.rows() == 0) return true;
  const MatrixXd of_u = u * phase.b;
  return u.rows() == phase.b.cols() &&
         (of_u - MatrixXd::Identity(u.rows(), u.rows())).norm() < 1e-9 &&
         (u * phase.a).norm() < 1e-9;
}

/// A message that was sent before this tick and is forgotten after it is a copy of what the other
/// numbers say. Those that are an exact function of them go, and C reads the others in their place.
void leave_out_copies(NodePlant& plant) {
  PlantPhase& phase = plant.phases.front();
  const Index n = phase.a.rows(), m = phase.b.cols();
  std::vector<Index> copies, others;
  for (Index i = 0; i < n; ++i) (phase.a.col(i).isZero(0.0) ? copies : others).push_back(i);
  if (others.empty()) return;
  MatrixXd next(static_cast<Index>(others.size()), n + m);
  for (std::size_t k = 0; k < others.size(); ++k) {
    next.row(static_cast<Index>(k)).head(n) = phase.a.row(others[k]);
    next.row(static_cast<Index>(k)).tail(m) = phase.b.row(others[k]);
  }
  const Eigen::CompleteOrthogonalDecomposition<MatrixXd> of_others(next.transpose());
  std::vector<bool> keeps(static_cast<std::size_t>(n), true);
  for (const Index i : copies) {
    Eigen::VectorXd row(n + m);
    row << phase.a.row(i).transpose(), phase.b.row(i).transpose();
    const Eigen::VectorXd share = of_others.solve(row);
    if (!((next.transpose() * share - row).norm() <= 1e-9 * row.norm())) continue;
    for (std::size_t k = 0; k < others.size(); ++k)
      phase.c.col(others[k]) += phase.c.col(i) * share[static_cast<Index>(k)];
    keeps[static_cast<std::size_t>(i)] = false;
  }
  keep(plant, keeps);
}

}  // namespace

KalmanDesign design_kalman(const KalmanRequest& request) {
  KalmanDesign result;
  const MatrixXd a = matrix(request.model.a, request.model.order);
  const MatrixXd c = matrix(request.model.c,
                            request.model.c.size() / std::max<std::size_t>(request.model.order, 1));
  const MatrixXd q = noise_of(request);
  Eigen::VectorXd r(c.rows());
  for (Index i = 0; i < r.size(); ++i) {
    const double deviation = request.measured[static_cast<std::size_t>(i)];
    r[i] = deviation * deviation;
  }
  // The regulator of the transposed system has the covariance of the prediction as its cost.
  const auto dual = solve_riccati({a.transpose(), c.transpose(), q, MatrixXd(r.asDiagonal()),
                                   MatrixXd::Zero(a.rows(), c.rows())});
  if (!dual) {
    explain(request, a, result);
    return result;
  }
  const MatrixXd pc = dual->p * c.transpose();
  const MatrixXd innovation = c * pc + MatrixXd(r.asDiagonal());
  const MatrixXd gain = innovation.ldlt().solve(pc.transpose()).transpose();
  const MatrixXd after = dual->p - gain * pc.transpose();
  result.gain = row_after_row(gain);
  result.r = {r.data(), r.data() + r.size()};
  const bool is_diagonal = q.isDiagonal(0.0);
  const Eigen::VectorXd diagonal = q.diagonal();
  result.q = is_diagonal ? std::vector<double>(diagonal.data(), diagonal.data() + diagonal.size())
                         : row_after_row(q);
  for (Index i = 0; i < after.rows(); ++i)
    result.deviations.push_back(std::sqrt(std::max(0.0, after(i, i))));
  result.spectral_radius = dual->spectral_radius;
  return result;
}

ModelDesign model_of(std::string_view printed, const Plan& plan) {
  ModelDesign result;
  auto plant = read_plant(printed, plan);
  if (!plant) {
    result.problem = kNoMatrices;
    return result;
  }
  // What the filter receives as u is no measurement: it does not need a state.
  NodePlant whole = *plant;
  for (PlantPhase& phase : plant->phases) {
    for (std::size_t i = 0; i < plant->received.size(); ++i) {
      if (plant->received[i].input != "measured") phase.c.row(static_cast<Index>(i)).setZero();
    }
  }
  reduce(*plant, Kept::seen);
  const PlantPhase first = plant->phases.front();
  for (std::size_t i = 0; i < plant->phases.size(); ++i) {
    const PlantPhase& next = whole.phases[(i + 1) % whole.phases.size()];
    if (first.b.cols() > 0 && plant->phases[i].input_messages != 1) {
      result.problem = fmt::format("between two of its ticks come {} of `u`",
                                   counted(plant->phases[i].input_messages, "message"));
      result.help = "give the filter the rate of what sends `u`";
      return result;
    }
    if (!receives_what_acts(whole, whole.phases[i], next)) {
      result.problem = "its `u` is not what was sent since the tick before";
      result.help = "connect `u` with `skip: true`, without a delay";
      return result;
    }
    if (is_same(first, plant->phases[i])) continue;
    result.problem = fmt::format(
        "the plant is another one from tick to tick of the filter, with {} until it repeats",
        counted(plant->phases.size(), "tick"));
    result.help =
        "give the filter the slowest rate of what is in between; if that is its own rate, the "
        "graph moves there: choose a state at which it rests with `--at`";
    return result;
  }
  plant->phases.resize(1);
  leave_out_copies(*plant);
  result.model.order = plant->state.size();
  const PlantPhase& phase = plant->phases.front();
  result.model.a = row_after_row(phase.a);
  result.model.b = row_after_row(phase.b);
  result.model.c = row_after_row(rows_of(*plant, phase.c, "measured"));
  result.state = plant->state;
  result.values = plant->values;
  result.losing = plant->losing;
  result.smoothing = plant->smoothing;
  return result;
}

}  // namespace eagerx::gen
