// Matrices of Eigen for those of a sampled system.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <complex>
#include <cstddef>

#include "generator/tools/linear/sampled_system.hpp"

namespace eagerx::gen {

inline Eigen::MatrixXd matrix_of(const Rows& rows, std::size_t columns) {
  Eigen::MatrixXd matrix(rows.size(), columns);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t k = 0; k < columns; ++k)
      matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = rows[i][k];
  }
  return matrix;
}

/// Whether a pole is an integrator: so near 1 that a double one is, with its rounding.
inline bool is_integrator(std::complex<double> z) {
  constexpr double kNear = 1e-6;
  return std::abs(z - 1.0) < kNear;
}

/// The largest |z|, but for integrators: what nothing holds stays, and is not unstable.
inline double spectral_radius(const Eigen::VectorXcd& poles) {
  double largest = 0.0;
  for (const std::complex<double> z : poles) {
    if (!is_integrator(z)) largest = std::max(largest, std::abs(z));
  }
  return largest;
}
inline Eigen::VectorXcd poles_of(const Eigen::MatrixXd& a) {
  return a.size() == 0 ? Eigen::VectorXcd() : Eigen::VectorXcd(a.eigenvalues());
}
inline std::size_t count_integrators(const Eigen::VectorXcd& poles) {
  return static_cast<std::size_t>(std::count_if(poles.begin(), poles.end(), is_integrator));
}

}  // namespace eagerx::gen
