// Converts between the numbers of a SIMD group, stored side by side for all lanes, and the rows of
// its environments.
#pragma once

#include <cstddef>
#include <cstring>
#include <eagerx/registers.hpp>
#include <utility>

namespace eagerx::environments {

/// `columns`: where the `Lanes` numbers of each are. Bits are moved and not looked at.
template <std::size_t Lanes>
class RowWriter {
 public:
  /// Number i of every lane goes to place `places[i]` of the lane's row of `width` numbers. Four at
  /// a time where they are side by side in a row, which they mostly are.
  template <std::size_t Numbers>
  static void spread_all(const float* const (&columns)[Numbers], const std::size_t* places,
                         float* rows, std::size_t width) {
    if (Numbers == 3 && width == 3 && places[0] == 0 && places[2] == 2) {
      spread_three(columns, rows);
      return;
    }
    std::size_t i = 0;
    while (i < Numbers) {
      // The last ones together with some that have been written.
      const std::size_t first = i + 4 <= Numbers || Numbers < 4 ? i : Numbers - 4;
      if (first + 4 <= Numbers && are_side_by_side(places + first)) {
        spread_four(columns + first, rows + places[first], width);
        i = first + 4;
      } else {
        spread(columns[i], rows + places[i], width);
        ++i;
      }
    }
  }

  /// A column into the rows of the lanes, each `width` numbers.
  static void spread(const float* column, float* to, std::size_t width) {
    constexpr std::size_t kAtATime = Lanes < 8 ? Lanes : 8;
    for (std::size_t k = 0; k < Lanes; k += kAtATime, to += kAtATime * width)
      detail::unrolled<kAtATime>([&](auto j) { to[j * width] = column[k + j]; });
  }

 private:
  static constexpr std::size_t kWidth = detail::kWidthFor<sizeof(float), Lanes>;
  static_assert(kWidth % 4 == 0);
  static constexpr std::size_t kBlocks = kWidth / 4;  // of 128 bits
  using Vector = typename detail::VectorOf<float, kWidth>::type;

  /// Each of the four: names in another order than the graph's may end where they would in a row.
  static bool are_side_by_side(const std::size_t* places) {
    return places[1] == places[0] + 1 && places[2] == places[0] + 2 && places[3] == places[0] + 3;
  }

  static void spread_four(const float* const* columns, float* to, std::size_t width) {
    for (std::size_t k = 0; k < Lanes; k += kWidth, to += kWidth * width) {
      Vector rows[4];
      transpose(columns, k, std::index_sequence<0, 1, 2, 3>{}, rows);
      if (width == 4) {
        store_side_by_side(rows, to);
      } else {
        each_row(rows, [&](std::size_t row, const void* from) {
          std::memcpy(to + row * width, from, 4 * sizeof(float));
        });
      }
    }
  }
  /// Rows of three numbers: the fourth that is written is the first of the next row, which comes
  /// later. Behind the last row of the SIMD group is memory of other objects.
  static void spread_three(const float* const* columns, float* to) {
    for (std::size_t k = 0; k < Lanes; k += kWidth) {
      Vector rows[4];
      transpose(columns, k, std::index_sequence<0, 1, 2, 2>{}, rows);
      each_row(rows, [&](std::size_t row, const void* from) {
        const bool is_last = k + row + 1 == Lanes;
        std::memcpy(to + 3 * (k + row), from, (is_last ? 3 : 4) * sizeof(float));
      });
    }
  }

  /// Rows 4 b + j of the lanes from `k` on are the blocks b of rows[j].
  template <std::size_t... Column>
  [[gnu::always_inline]] static void transpose(const float* const* columns, std::size_t k,
                                               std::index_sequence<Column...> /*which*/,
                                               Vector (&rows)[4]) {
    Vector in[4];
    std::size_t i = 0;
    (std::memcpy(&in[i++], columns[Column] + k, sizeof(Vector)), ...);
    const Vector low = in_blocks<0, 4, 1, 5>(in[0], in[1]);
    const Vector high = in_blocks<2, 6, 3, 7>(in[0], in[1]);
    const Vector next_low = in_blocks<0, 4, 1, 5>(in[2], in[3]);
    const Vector next_high = in_blocks<2, 6, 3, 7>(in[2], in[3]);
    rows[0] = in_blocks<0, 1, 4, 5>(low, next_low);
    rows[1] = in_blocks<2, 3, 6, 7>(low, next_low);
    rows[2] = in_blocks<0, 1, 4, 5>(high, next_high);
    rows[3] = in_blocks<2, 3, 6, 7>(high, next_high);
  }
  /// The same choice in each block: 0 to 3 of the block of `a`, 4 to 7 of that of `b`.
  template <std::size_t... Choice>
  [[gnu::always_inline]] static Vector in_blocks(const Vector& a, const Vector& b) {
    constexpr std::size_t kChoice[] = {Choice...};
    constexpr auto of = [](std::size_t i) {
      const std::size_t choice = kChoice[i % 4];
      return i / 4 * 4 + choice % 4 + (choice < 4 ? 0 : kWidth);
    };
    return [&]<std::size_t... I>(std::index_sequence<I...>) __attribute__((always_inline)) {
      return __builtin_shufflevector(a, b, of(I)...);
    }
    (std::make_index_sequence<kWidth>{});
  }
  /// Blocks `A` of `a` and `B` of `b`, … in the order in which they are named: (vector, block).
  template <std::size_t... Block>
  [[gnu::always_inline]] static Vector blocks(const Vector& a, const Vector& b) {
    constexpr std::size_t kBlock[] = {Block...};
    constexpr auto of = [](std::size_t i) { return kBlock[i / 4] * 4 + i % 4; };
    return [&]<std::size_t... I>(std::index_sequence<I...>) __attribute__((always_inline)) {
      return __builtin_shufflevector(a, b, of(I)...);
    }
    (std::make_index_sequence<kWidth>{});
  }

  /// Calls f(row, pointer to its four numbers), from the first row to the last.
  template <class F>
  [[gnu::always_inline]] static void each_row(const Vector (&rows)[4], F&& f) {
    detail::unrolled<kBlocks>([&](auto block) {
      detail::unrolled<4>([&](auto j) {
        const auto four = detail::picked<4 * block, 1, 4>(rows[j], rows[j]);
        f(4 * block + j, &four);
      });
    });
  }
  /// Rows of four numbers, whole registers of them.
  [[gnu::always_inline]] static void store_side_by_side(const Vector (&r)[4], float* to) {
    Vector out[4];
    if constexpr (kBlocks == 1) {
      detail::unrolled<4>([&](auto j) { out[j] = r[j]; });
    } else if constexpr (kBlocks == 2) {
      out[0] = blocks<0, 2>(r[0], r[1]);
      out[1] = blocks<0, 2>(r[2], r[3]);
      out[2] = blocks<1, 3>(r[0], r[1]);
      out[3] = blocks<1, 3>(r[2], r[3]);
    } else {
      const Vector a = blocks<0, 1, 4, 5>(r[0], r[1]), b = blocks<0, 1, 4, 5>(r[2], r[3]);
      const Vector c = blocks<2, 3, 6, 7>(r[0], r[1]), d = blocks<2, 3, 6, 7>(r[2], r[3]);
      out[0] = blocks<0, 2, 4, 6>(a, b);
      out[1] = blocks<1, 3, 5, 7>(a, b);
      out[2] = blocks<0, 2, 4, 6>(c, d);
      out[3] = blocks<1, 3, 5, 7>(c, d);
    }
    for (std::size_t j = 0; j < 4; ++j) std::memcpy(to + j * kWidth, &out[j], sizeof out[j]);
  }
};

}  // namespace eagerx::environments
