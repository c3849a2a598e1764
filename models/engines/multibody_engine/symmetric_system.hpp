// Symmetric, positive definite systems of equations of fixed size.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/math.hpp>

namespace eagerx::models::multibody {

/// A = L·D·Lᵀ, of the lower triangle of a matrix [n][n].
template <class Real, std::size_t n>
class SymmetricSystem {
 public:
  using Matrix = std::array<std::array<Real, n>, n>;

  explicit SymmetricSystem(const Matrix& a) : factor_(a) {
    // Row by row; element (i, j) holds L·D until D of its column has been divided out.
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        for (std::size_t k = 0; k < j; ++k) factor_[i][j] -= factor_[i][k] * factor_[j][k];
      }
      for (std::size_t j = 0; j < i; ++j) {
        const Real scaled = factor_[i][j];
        factor_[i][j] = scaled * factor_[j][j];
        factor_[i][i] -= scaled * factor_[i][j];
      }
      factor_[i][i] = Real(LaneOf<Real>(1)) / factor_[i][i];
    }
  }

  /// x with A·x = b.
  [[nodiscard]] std::array<Real, n> solve(std::array<Real, n> x) const {
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < i; ++j) x[i] -= factor_[i][j] * x[j];
    }
    for (std::size_t i = 0; i < n; ++i) x[i] *= factor_[i][i];
    for (std::size_t i = n; i-- > 0;) {
      for (std::size_t j = i + 1; j < n; ++j) x[i] -= factor_[j][i] * x[j];
    }
    return x;
  }

 private:
  Matrix factor_;  // L below the diagonal, 1/D on it
};

}  // namespace eagerx::models::multibody
