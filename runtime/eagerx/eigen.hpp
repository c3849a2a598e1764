// Messages as Eigen vectors and matrices, without a copy. Only for entities that include it:
// nothing else in the runtime needs Eigen.
//
// The order of sums in Eigen's products depends on the instruction set: entities that must give the
// same bits everywhere use Eigen for storage and element-wise arithmetic only.
#pragma once

#ifndef EIGEN_NO_MALLOC
#define EIGEN_NO_MALLOC
#endif
#include <Eigen/Core>
#include <cstddef>
#include <eagerx/message.hpp>

namespace eagerx {

/// A message of shape [N] as a column vector.
template <class T, std::size_t N>
auto as_vector(Array<T, N>& message) {
  return Eigen::Map<Eigen::Matrix<T, static_cast<int>(N), 1>>(message.data);
}
template <class T, std::size_t N>
auto as_vector(const Array<T, N>& message) {
  return Eigen::Map<const Eigen::Matrix<T, static_cast<int>(N), 1>>(message.data);
}

/// A message of shape [Rows, Columns], row-major, as a matrix.
template <class T, std::size_t Rows, std::size_t Columns>
auto as_matrix(Array<T, Rows, Columns>& message) {
  constexpr int kOrder = Columns == 1 ? Eigen::ColMajor : Eigen::RowMajor;
  return Eigen::Map<Eigen::Matrix<T, static_cast<int>(Rows), static_cast<int>(Columns), kOrder>>(
      message.data);
}
template <class T, std::size_t Rows, std::size_t Columns>
auto as_matrix(const Array<T, Rows, Columns>& message) {
  constexpr int kOrder = Columns == 1 ? Eigen::ColMajor : Eigen::RowMajor;
  return Eigen::Map<
      const Eigen::Matrix<T, static_cast<int>(Rows), static_cast<int>(Columns), kOrder>>(
      message.data);
}

}  // namespace eagerx
