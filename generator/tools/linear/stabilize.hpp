// Gains of output feedback whose closed loop is stable. Inside linear/ only.
#pragma once

#include <optional>
#include <vector>

#include "generator/tools/linear/periodic.hpp"

namespace eagerx::gen {

/// log |z| of the slowest pole of u = -K·C·x over all phases, and its derivatives by K.
struct SlowestPole {
  double log_radius = 0.0;
  Eigen::MatrixXd slope;  // [m][p]
};
SlowestPole slowest_pole(const PeriodicProblem& problem, const Eigen::MatrixXd& gain);

/// Gains with a spectral radius below 1, of those that descending in it finds from each of
/// `starts` [m][p]; and, if none of them leads to one, from random gains around the last of them,
/// always the same. C has units in which each received number moves by about 1.
///
/// The spectral radius has no derivative where two poles are equally slow; BFGS with a line search
/// for Wolfe's weak conditions passes such edges (Lewis, Overton: Nonsmooth optimization via
/// quasi-Newton methods, Math. Programming 141 (2013), 135-163). Output feedback has no necessary
/// and sufficient test, so that nothing is proven if none is found (Burke, Henrion, Lewis, Overton:
/// Stabilization via nonsmooth, nonconvex optimization, IEEE Trans. Automatic Control 51 (2006),
/// 1760-1769).
std::vector<Eigen::MatrixXd> stabilizing_gains(const PeriodicProblem& problem,
                                               const std::vector<Eigen::MatrixXd>& starts);

}  // namespace eagerx::gen
