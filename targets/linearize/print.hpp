// Matrices and lists of JSON.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <eagerx/math.hpp>
#include <vector>

namespace eagerx::linearize {

/// Numbers in rows.
using Matrix = std::vector<std::vector<double>>;

/// A member that follows others.
inline void print_matrix(const char* name, const Matrix& matrix) {
  std::printf(",\n\"%s\": [", name);
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    std::printf(i == 0 ? "\n[" : ",\n[");
    for (std::size_t k = 0; k < matrix[i].size(); ++k)
      std::printf(k == 0 ? "%.17g" : ", %.17g", matrix[i][k]);
    std::printf("]");
  }
  std::printf("]");
}
/// The same of whole numbers.
template <class Numbers>
void print_list(const char* name, const Numbers& numbers) {
  std::printf(",\n\"%s\": [", name);
  const char* separator = "";
  for (const auto number : numbers) {
    std::printf("%s%zu", separator, std::size_t{number});
    separator = ", ";
  }
  std::printf("]");
}

inline bool are_finite(const Matrix& matrix) {
  return std::all_of(matrix.begin(), matrix.end(), [](const std::vector<double>& row) {
    return std::all_of(row.begin(), row.end(), [](double x) { return eagerx::isfinite(x); });
  });
}

}  // namespace eagerx::linearize
