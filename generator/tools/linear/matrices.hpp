// Matrices of Eigen for those of a sampled system.
#pragma once

#include <Eigen/Dense>

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

inline double spectral_radius(const Eigen::MatrixXd& a) {
  return a.size() == 0 ? 0.0 : a.eigenvalues().cwiseAbs().maxCoeff();
}

}  // namespace eagerx::gen
