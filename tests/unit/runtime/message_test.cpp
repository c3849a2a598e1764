// eagerx/message.hpp: arrays, scalars and what is the same for both.
#include <gtest/gtest.h>

#include <eagerx/message.hpp>
#include <numeric>
#include <type_traits>

namespace eagerx {
namespace {

static_assert(std::is_trivially_copyable_v<Array<float, 3>>);
static_assert(std::is_aggregate_v<Array<float, 3>>);
static_assert(sizeof(Array<float, 2, 3>) == 6 * sizeof(float), "no padding");
static_assert(size_of<double> == 1 && size_of<bool> == 1);
static_assert(size_of<Array<double, 2, 3, 4>> == 24);
static_assert(std::is_same_v<ScalarOf<std::int64_t>, std::int64_t>);
static_assert(std::is_same_v<ScalarOf<Array<std::uint8_t, 4>>, std::uint8_t>);

TEST(Array, IsFlatAndRowMajor) {
  constexpr Array<int, 2, 3> kMatrix = {{1, 2, 3, 4, 5, 6}};
  static_assert(kMatrix.size() == 6);
  static_assert(kMatrix[3] == 4, "the first element of the second row");
  EXPECT_EQ(std::accumulate(kMatrix.begin(), kMatrix.end(), 0), 21);
}

TEST(Array, IsWrittenThroughItsIndexAndItsIterators) {
  Array<int, 3> message{};
  message[1] = 5;
  for (int& x : message) ++x;
  EXPECT_EQ(message, (Array<int, 3>{{1, 6, 1}}));
  EXPECT_NE(message, (Array<int, 3>{{1, 6, 2}}));
}

TEST(Message, ElementsOfScalarsAndArraysAreWrittenAlike) {
  double scalar = 1;
  element(scalar, 0) = 2;
  EXPECT_EQ(scalar, 2);
  Array<double, 2> array{};
  element(array, 1) = 3;
  EXPECT_EQ(array, (Array<double, 2>{{0, 3}}));
}

TEST(Message, ElementsOfConstantMessagesAreRead) {
  const double scalar = 4;
  EXPECT_EQ(&element(scalar, 0), &scalar);
  const Array<double, 2> array = {{5, 6}};
  EXPECT_EQ(&element(array, 1), &array.data[1]);
  static_assert(std::is_same_v<decltype(element(array, 0)), const double&>);
}

TEST(Message, FilledHasTheValueEverywhere) {
  static_assert(filled<float>(2.5F) == 2.5F);
  static_assert(filled<Array<int, 2, 2>>(7) == Array<int, 2, 2>{{7, 7, 7, 7}});
  static_assert(filled<Array<bool, 2>>(true) == Array<bool, 2>{{true, true}});
}

}  // namespace
}  // namespace eagerx
