// Shared by tests of blocks: one tick at a time, lanes of SIMD vectors, references.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <eagerx/random.hpp>
#include <eagerx/simd.hpp>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include "tests/unit/models/csv.hpp"
#include "tests/unit/models/dynamic_block_io.hpp"

namespace eagerx::models::testing::blocks {

template <class Real>
constexpr Real kNan = std::numeric_limits<Real>::quiet_NaN();

/// A window of the message, or of nothing.
template <class Message>
Skipped<Message> window(const Message& message) {
  return {&message, 1, 1};
}
template <class Message>
Skipped<Message> nothing() {
  return {nullptr, 0, 0};
}

/// A node that ticks; its output is an array.
template <template <class> class Node, class Io>
struct Ticking {
  using Output =
      std::remove_cvref_t<decltype(std::declval<std::remove_reference_t<
                                       decltype(std::declval<typename Io::Outputs>().y)>>())>;
  Node<Io> node{};
  Seq n = 0;

  explicit Ticking(const typename Io::States& states = {}) { node.reset(states); }
  void reset(const typename Io::States& states = {}) {
    node.reset(states);
    n = 0;
  }
  /// With a message for each input.
  template <class... Message>
  Output operator()(const Message&... messages) {
    return tick({window(messages)...});
  }
  Output tick(const typename Io::Inputs& in) {
    Output y{};
    for (auto& each : y) each = typename Io::Real(77);
    typename Io::Outputs out{y};
    node.callback({n++}, in, out);
    return y;
  }
};

/// Runs a node of SIMD vectors and one of plain numbers for each lane, on the same random messages
/// (with NaN among them) of N... elements: the bits are equal.
template <template <class> class Node, template <class> class Io, std::size_t... N>
void expect_lanes(int ticks = 40) {
  using P = Simd<float, 4>;
  Ticking<Node, Io<P>> vectorized;
  std::array<Ticking<Node, Io<float>>, 4> plain;
  Random random({7, 0, 0}, 1);
  for (int t = 0; t < ticks; ++t) {
    std::tuple<V<P, N>...> messages;
    const auto fill = [&](auto& message) {
      for (auto& x : message) {
        for (int k = 0; k < 4; ++k) {
          set_lane(x, k, random.below(12) == 0 ? kNan<float> : random.uniform(-3.0F, 3.0F));
        }
      }
    };
    std::apply([&](auto&... message) { (fill(message), ...); }, messages);
    const auto y = std::apply([&](auto&... message) { return vectorized(message...); }, messages);
    for (int k = 0; k < 4; ++k) {
      const auto in_lane = [k](const auto& message) {
        V<float, std::remove_cvref_t<decltype(message)>::size()> one{};
        for (std::size_t i = 0; i < one.size(); ++i) one[i] = lane(message[i], k);
        return one;
      };
      const auto expected = std::apply(
          [&](auto&... message) { return plain[static_cast<std::size_t>(k)](in_lane(message)...); },
          messages);
      for (std::size_t i = 0; i < expected.size(); ++i) {
        const float found = lane(y[i], k);
        if (eagerx::isnan(expected[i]) && eagerx::isnan(found)) continue;
        ASSERT_EQ(bits(found), bits(expected[i])) << "tick " << t << " lane " << k << " of " << i;
      }
    }
  }
}

/// A case of blocks.csv: for each sample its numbers, inputs first.
inline std::vector<std::vector<double>> reference(const std::string& name) {
  std::vector<std::vector<double>> rows;
  static const std::vector<Row> kAll = read_csv("blocks.csv");
  for (const Row& row : kAll) {
    if (row[0] != name) continue;
    std::vector<double> numbers;
    for (std::size_t i = 1; i < row.size(); ++i) numbers.push_back(std::stod(row[i]));
    rows.push_back(numbers);
  }
  EXPECT_GE(rows.size(), 10U) << name;
  return rows;
}
/// `N` numbers of a row, from number `from` on.
template <class Real, std::size_t N>
V<Real, N> part(const std::vector<double>& row, std::size_t from) {
  V<Real, N> result{};
  for (std::size_t i = 0; i < N; ++i) result[i] = static_cast<Real>(row.at(from + i));
  return result;
}
/// 1e-12 in double and `in_float` in float, of a number near 1.
template <class Real, std::size_t N>
void expect_near(const V<Real, N>& found, const std::vector<double>& row, std::size_t from,
                 double in_float) {
  for (std::size_t i = 0; i < N; ++i) {
    const double expected = row.at(from + i);
    const double scale = std::abs(expected) > 1.0 ? std::abs(expected) : 1.0;
    EXPECT_NEAR(static_cast<double>(found[i]), expected,
                scale * (sizeof(Real) == 8 ? 1e-12 : in_float));
  }
}

}  // namespace eagerx::models::testing::blocks
