// Letters as strokes, for text in scenes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string_view>

namespace eagerx::picture {

/// A letter: its width, and its strokes, separated by blanks. A stroke is a sequence of points,
/// each a digit for x and a letter for y: a is -3, d the baseline, j the height of an x, m = 9 that
/// of an X. A stroke that begins with ~ is a curve: its inner points are the intersections of its
/// tangents.
struct Glyph {
  int width;
  std::string_view strokes;
};
inline constexpr int kGlyphHeight = 9;
inline constexpr int kGlyphGap = 3;  // between letters

inline constexpr Glyph kGlyphs[] = {
    {2, ""},                                    // blank
    {0, "0m0g 0d0d"},                           // !
    {2, "0m0k 2m2k"},                           // "
    {6, "1e2l 4e5l 0g6g 0j6j"},                 // #
    {6, "~6k6m0m0i6h6d0d0f 3n3c"},              // $
    {6, "0d6m ~1m0m0k2k2m1m ~5f4f4d6d6f5f"},    // %
    {6, "6d1k ~1k1m5m5k 5k0g ~0g0d6d6h"},       // &
    {0, "0m0k"},                                // '
    {2, "~2n0k0e2b"},                           // (
    {2, "~0n2k2e0b"},                           // )
    {4, "2g2k 0h4j 0j4h"},                      // *
    {6, "0h6h 3e3k"},                           // +
    {1, "1d0b"},                                // ,
    {4, "0h4h"},                                // -
    {0, "0d0d"},                                // .
    {4, "0c4m"},                                // /
    {6, "~3m0m0d6d6m3m"},                       // 0
    {6, "1k3m3d 1d5d"},                         // 1
    {6, "~0k0m6m6i0d 0d6d"},                    // 2
    {6, "~0l1m6m6i2i ~2i6i6d0d0f"},             // 3
    {6, "4d4m0g6g"},                            // 4
    {6, "5m1m0i ~0i1j6j6d0d0f"},                // 5
    {6, "~5m0m0d6d6j0j0g"},                     // 6
    {6, "0m6m2d"},                              // 7
    {6, "~3m1m1i5i5m3m ~3i0i0d6d6i3i"},         // 8
    {6, "~1d6d6m0m0g6g6j"},                     // 9
    {0, "0d0d 0i0i"},                           // :
    {1, "1d0b 1i1i"},                           // ;
    {5, "5k0h5e"},                              // <
    {5, "0g5g 0i5i"},                           // =
    {5, "0k5h0e"},                              // >
    {5, "~0k0m5m5i2i2g 2d2d"},                  // ?
    {6, "~5g5k1k1g5g5h ~5h5g7g7m0m0d6d"},       // @
    {6, "0d3m6d 1g5g"},                         // A
    {6, "0d0m ~0m2m5m5i2i0i ~0i2i6i6d2d0d"},    // B
    {6, "~6k6m0m0d6d6f"},                       // C
    {6, "0d0m ~0m1m6m6d1d0d"},                  // D
    {5, "5m0m0d5d 0i4i"},                       // E
    {5, "5m0m0d 0i4i"},                         // F
    {6, "~6k6m0m0d6d6h 6h3h"},                  // G
    {6, "0d0m 6d6m 0i6i"},                      // H
    {0, "0d0m"},                                // I
    {4, "4m4g ~4g4d0d0g"},                      // J
    {6, "0d0m 6m0h 2j6d"},                      // K
    {5, "0m0d5d"},                              // L
    {6, "0d0m3f6m6d"},                          // M
    {6, "0d0m6d6m"},                            // N
    {6, "~3m0m0d6d6m3m"},                       // O
    {6, "0d0m ~0m2m6m6h2h0h"},                  // P
    {6, "~3m0m0d6d6m3m 4f7c"},                  // Q
    {6, "0d0m ~0m2m6m6h2h0h 3h6d"},             // R
    {6, "~6k6m0m0i6h6d0d0f"},                   // S
    {6, "0m6m 3m3d"},                           // T
    {6, "0m0g ~0g0d6d6g 6g6m"},                 // U
    {6, "0m3d6m"},                              // V
    {8, "0m2d4l6d8m"},                          // W
    {6, "0d6m 0m6d"},                           // X
    {6, "0m3h6m 3h3d"},                         // Y
    {6, "0m6m0d6d"},                            // Z
    {2, "2n0n0b2b"},                            // [
    {4, "0m4c"},                                // backslash
    {2, "0n2n2b0b"},                            // ]
    {4, "0j2m4j"},                              // ^
    {6, "0c6c"},                                // _
    {1, "0m1k"},                                // `
    {6, "~3j0j0d6d6j3j 6j6d"},                  // a
    {6, "0m0d ~3j0j0d6d6j3j"},                  // b
    {6, "~6i6j0j0d6d6e"},                       // c
    {6, "6m6d ~3j0j0d6d6j3j"},                  // d
    {6, "0g6g ~6g6j0j0d6d6e"},                  // e
    {4, "~4m1m1i 1i1d 0j3j"},                   // f
    {6, "~3j0j0d6d6j3j 6j6c ~6c6a0a0b"},        // g
    {5, "0d0m ~0g0j5j5g 5g5d"},                 // h
    {0, "0d0j 0m0m"},                           // i
    {1, "1j1b ~1b1a0a 1m1m"},                   // j
    {5, "0d0m 5j0g 2h5d"},                      // k
    {0, "0d0m"},                                // l
    {8, "0d0j ~0g0j4j4g 4g4d ~4g4j8j8g 8g8d"},  // m
    {5, "0d0j ~0g0j5j5g 5g5d"},                 // n
    {6, "~3j0j0d6d6j3j"},                       // o
    {6, "0a0j ~3j0j0d6d6j3j"},                  // p
    {6, "6a6j ~3j0j0d6d6j3j"},                  // q
    {3, "0d0j ~0g0j3j"},                        // r
    {5, "~5i5j0j0g5g5d0d0e"},                   // s
    {3, "1l1f ~1f1d3d 0j3j"},                   // t
    {5, "0j0g ~0g0d5d5g 5j5d"},                 // u
    {6, "0j3d6j"},                              // v
    {8, "0j2d4j6d8j"},                          // w
    {5, "0d5j 0j5d"},                           // x
    {6, "0j3d 6j3d1a"},                         // y
    {5, "0j5j0d5d"},                            // z
    {3, "~3n1n1h0h ~0h1h1b3b"},                 // {
    {0, "0n0b"},                                // |
    {3, "~0n2n2h3h ~3h2h2b0b"},                 // }
    {6, "~0h0i3i3g6g6h"},                       // ~
};

/// Any other character is a blank.
constexpr const Glyph& glyph_of(unsigned char character) {
  constexpr unsigned char kFirst = ' ';
  const bool known = character >= kFirst && character < kFirst + std::size(kGlyphs);
  return kGlyphs[known ? character - kFirst : 0];
}
constexpr int glyph_x(char digit) {
  return digit - '0';
}
constexpr int glyph_y(char letter) {
  return letter - 'd';
}

/// A text of a scene with its number inserted: at most 18 characters plus those of the number.
class Line {
 public:
  constexpr std::size_t size() const { return size_; }
  constexpr unsigned char operator[](std::size_t i) const { return text_[i]; }

  constexpr void add(unsigned char character) {
    if (size_ < kMost) text_[size_++] = character;
  }
  /// Rounded to `decimals`, 0 to 6. Asterisks if the result has more than nine digits.
  constexpr void add_number(float value, int decimals) {
    if (!(value == value)) return add_all("nan");
    constexpr float kLargest = 2.0e9F;
    float scaled = value < 0.0F ? -value : value;
    for (int i = 0; i < decimals; ++i) scaled *= 10.0F;
    if (!(scaled < kLargest)) return add_all("***");
    // NOLINTNEXTLINE(bugprone-incorrect-roundings): the same bits everywhere, which matter more
    auto whole = static_cast<std::uint32_t>(scaled + 0.5F);
    if (value < 0.0F && whole != 0) add('-');
    char digits[12] = {};
    int count = 0;
    for (; whole != 0 || count <= decimals; whole /= 10)
      digits[count++] = static_cast<char>('0' + whole % 10);
    while (count-- > 0) {
      add(static_cast<unsigned char>(digits[count]));
      if (count == decimals && decimals > 0) add('.');
    }
  }

 private:
  constexpr void add_all(std::string_view text) {
    for (const char c : text) add(static_cast<unsigned char>(c));
  }
  static constexpr std::size_t kMost = 32;
  unsigned char text_[kMost]{};
  std::size_t size_ = 0;
};

}  // namespace eagerx::picture
