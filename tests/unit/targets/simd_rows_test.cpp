// Numbers of a SIMD vector, as rows of its environments: in whatever order the columns are.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <targets/environments/simd_rows.hpp>
#include <vector>

namespace eagerx::environments {
namespace {

/// Number i of lane k is 100 k + i, and behind the last row is foreign memory.
template <std::size_t Lanes, std::size_t Numbers>
bool is_spread(const std::array<std::size_t, Numbers>& places) {
  alignas(64) float values[Numbers][Lanes];
  const float* columns[Numbers];
  for (std::size_t i = 0; i < Numbers; ++i) {
    columns[i] = values[i];
    for (std::size_t k = 0; k < Lanes; ++k) values[i][k] = static_cast<float>(100 * k + i);
  }
  std::vector<float> rows(Lanes * Numbers + 4, -1.0F), expected = rows;
  for (std::size_t i = 0; i < Numbers; ++i) {
    for (std::size_t k = 0; k < Lanes; ++k) expected[k * Numbers + places[i]] = values[i][k];
  }
  RowWriter<Lanes>::spread_all(columns, places.data(), rows.data(), Numbers);
  return rows == expected;
}

template <std::size_t Lanes, std::size_t Numbers>
void expect_every_order() {
  std::array<std::size_t, Numbers> places;
  std::iota(places.begin(), places.end(), 0);
  std::size_t wrong = 0, orders = 0;
  do {
    wrong += is_spread<Lanes>(places) ? 0 : 1;
    ++orders;
  } while (std::next_permutation(places.begin(), places.end()));
  EXPECT_EQ(wrong, 0U) << "of " << orders << " orders of " << Numbers << " numbers, " << Lanes
                       << " lanes";
}

template <std::size_t Lanes>
void expect_every_order_and_width() {
  expect_every_order<Lanes, 1>();
  expect_every_order<Lanes, 2>();
  expect_every_order<Lanes, 3>();
  expect_every_order<Lanes, 4>();
  expect_every_order<Lanes, 5>();
  expect_every_order<Lanes, 6>();
  expect_every_order<Lanes, 7>();
}

// Observations [a, c, b, d] were once written as a, b, c, d, because the first and the last of four
// numbers are where they are in a row.
TEST(SimdRows, NumbersGoToTheirPlacesInEveryOrder) {
  expect_every_order_and_width<4>();
  expect_every_order_and_width<8>();
  expect_every_order_and_width<16>();
  expect_every_order_and_width<64>();
}

}  // namespace
}  // namespace eagerx::environments
