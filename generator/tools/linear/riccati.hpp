// Riccati's and Stein's equations in discrete time.
#pragma once

#include <Eigen/Dense>
#include <optional>

namespace eagerx::gen {

/// The cost Σ x'·Q·x + 2·x'·S·u + u'·R·u of x' = A·x + B·u, with n states and m inputs.
struct LinearQuadratic {
  Eigen::MatrixXd a, b;     // [n][n], [n][m]
  Eigen::MatrixXd q, r, s;  // [n][n], [m][m] positive definite, [n][m]
};

/// u = -gain·x is least in cost, which is x'·p·x.
struct Regulator {
  Eigen::MatrixXd p, gain;       // [n][n], [m][n]
  double spectral_radius = 0.0;  // of A - B·gain
};

/// The stabilizing solution of P = A'PA - (A'PB + S)(R + B'PB)⁻¹(B'PA + S') + Q, to about 1e-12 of
/// its largest element; nothing if there is none: an unstable mode that no input moves or that
/// costs nothing.
///
/// Structure-preserving doubling (SDA): k steps are 2^k steps of the recursion of the covariance.
/// Chu, Fan, Lin, Wang: Structure-preserving algorithms for periodic discrete-time algebraic
/// Riccati equations, Int. J. Control 77 (2004), 767-788. Newton's method follows, so that rounding
/// in the doubling does not stay: Hewer, IEEE Trans. Automatic Control 16 (1971), 382-384.
std::optional<Regulator> solve_riccati(const LinearQuadratic& problem);

/// X = A·X·A' + Q for a stable A, by doubling: Smith, SIAM J. Applied Math. 16 (1968), 198-201.
Eigen::MatrixXd solve_stein(const Eigen::MatrixXd& a, const Eigen::MatrixXd& q);

/// The largest |z| of the eigenvalues of a matrix; 0 without one.
double radius_of(const Eigen::MatrixXd& a);

}  // namespace eagerx::gen
