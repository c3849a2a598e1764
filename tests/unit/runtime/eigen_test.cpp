#include <gtest/gtest.h>

#include <eagerx/eigen.hpp>

namespace {

using eagerx::Array;

TEST(Eigen, VectorSharesTheMessage) {
  Array<float, 3> message{{1.0F, 2.0F, 3.0F}};
  eagerx::as_vector(message) *= 2.0F;
  EXPECT_EQ(message, (Array<float, 3>{{2.0F, 4.0F, 6.0F}}));
}

TEST(Eigen, MatrixIsRowMajor) {
  const Array<double, 2, 3> message{{1, 2, 3, 4, 5, 6}};
  EXPECT_EQ(eagerx::as_matrix(message)(0, 2), 3.0);
  EXPECT_EQ(eagerx::as_matrix(message)(1, 0), 4.0);
}

TEST(Eigen, OneColumn) {
  Array<int, 3, 1> message{{1, 2, 3}};
  eagerx::as_matrix(message)(2, 0) = 7;
  EXPECT_EQ(message[2], 7);
}

}  // namespace
