// Numbers as decimal text for boards: no printf, no tables, no heap. Exact integer arithmetic, so
// it is correct but slow (some thousand instructions per number).
#pragma once

#include <algorithm>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace eagerx::board {

inline constexpr std::size_t kLongestInteger = 20;  // -9223372036854775808

/// Writes the digits of `value` and returns how many characters they are.
template <std::integral T>
std::size_t write_integer(char* text, T value) {
  constexpr std::uint64_t kTen = 10;
  const bool negative = value < 0;
  auto rest = static_cast<std::uint64_t>(value);
  if (negative) rest = 0 - rest;
  char digits[kLongestInteger];
  std::size_t n = 0;
  do {
    digits[n++] = static_cast<char>('0' + static_cast<char>(rest % kTen));
    rest /= kTen;
  } while (rest != 0);
  if (negative) digits[n++] = '-';
  std::reverse_copy(digits, digits + n, text);
  return n;
}

/// A natural number of a fixed largest size, in words of nine decimal digits, the lowest first.
template <std::size_t Words>
class Natural {
 public:
  explicit Natural(std::uint64_t value) {
    for (; value != 0; value /= kBase) words_[n_++] = static_cast<std::uint32_t>(value % kBase);
  }
  /// `factor` to the power of `exponent`; `chunk` is the largest power, of `chunk_exponent`, that
  /// fits.
  void multiply(std::uint32_t factor, int exponent, std::uint32_t chunk, int chunk_exponent) {
    for (; exponent >= chunk_exponent; exponent -= chunk_exponent) multiply(chunk);
    for (; exponent > 0; --exponent) multiply(factor);
  }
  /// `size` digits into `digits`, the highest first, with zeros in front.
  void write(char* digits, std::size_t size) const {
    for (std::size_t i = size, word = 0; i > 0; ++word) {
      std::uint32_t rest = word < n_ ? words_[word] : 0;
      for (int k = 0; k < kDigits && i > 0; ++k, rest /= 10U) {
        digits[--i] = static_cast<char>('0' + static_cast<char>(rest % 10U));
      }
    }
  }
  std::size_t digits() const { return n_ * kDigits; }

 private:
  static constexpr std::uint32_t kBase = 1'000'000'000;
  static constexpr int kDigits = 9;

  void multiply(std::uint32_t factor) {
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < n_; ++i) {
      carry += std::uint64_t{words_[i]} * factor;
      words_[i] = static_cast<std::uint32_t>(carry % kBase);
      carry /= kBase;
    }
    if (carry != 0) words_[n_++] = static_cast<std::uint32_t>(carry);
  }

  std::uint32_t words_[Words];
  std::size_t n_ = 0;
};

/// Text of a floating-point number: the fewest digits that read back to the same bits, in fixed or
/// scientific notation, whichever is shorter. The same text as std::to_chars but for powers of two
/// whose shortest text is not their nearest; those get a digit more.
template <std::floating_point T>
class Decimal {
 public:
  static constexpr std::size_t kLongestText = 32;

  static std::size_t write(char* text, T value) {
    char* out = text;
    if (value != value) return append(out, "nan"), 3;
    const Bits bits = std::bit_cast<Bits>(value);
    if ((bits >> (8 * sizeof(T) - 1)) != 0) *out++ = '-';
    const Bits magnitude = bits & ~(Bits{1} << (8 * sizeof(T) - 1));
    if (magnitude == 0) {
      append(out, "0");
    } else if ((magnitude >> kFractionBits) == kLargestExponent) {
      append(out, "inf");
    } else {
      Decimal(magnitude).write_to(out);
    }
    return static_cast<std::size_t>(out - text);
  }

 private:
  using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
  static constexpr int kFractionBits = std::numeric_limits<T>::digits - 1;
  static constexpr Bits kLargestExponent = (Bits{2} << (8 * sizeof(T) - 2 - kFractionBits)) - 1;
  static constexpr int kLowestExponent = std::numeric_limits<T>::min_exponent -
                                         std::numeric_limits<T>::digits - 2;  // of the ends below
  static constexpr int kMostDigits = std::numeric_limits<T>::max_digits10;
  // Digits of the longest exact value: 5^-kLowestExponent times a significand of kFractionBits + 3
  // bits.
  static constexpr std::size_t kExactDigits =
      static_cast<std::size_t>(-kLowestExponent * 7 / 10 + (kFractionBits + 3) * 31 / 100 + 3);
  static constexpr std::size_t kWords = kExactDigits / 9 + 2;

  /// A number and the ends of the interval that rounds to it, as integers times 10^-scale_.
  explicit Decimal(Bits magnitude) {
    const auto exponent_bits = static_cast<int>(magnitude >> kFractionBits);
    Bits significand = magnitude & ((Bits{1} << kFractionBits) - 1);
    const bool lowest_of_binade = significand == 0 && exponent_bits > 1;
    if (exponent_bits > 0) significand |= Bits{1} << kFractionBits;
    even_ = (significand & 1U) == 0;
    // In quarters of the last place: half a place up, half a place (a quarter below a power of 2)
    // down.
    const std::uint64_t quarters = std::uint64_t{significand} * 4;
    const int exponent = std::max(exponent_bits, 1) - 1 + kLowestExponent;
    scale_ = std::max(-exponent, 0);
    write_scaled(value_, quarters, exponent);
    write_scaled(low_, quarters - (lowest_of_binade ? 1 : 2), exponent);
    write_scaled(high_, quarters + 2, exponent);
  }

  static void write_scaled(char* digits, std::uint64_t significand, int exponent) {
    Natural<kWords> natural(significand);
    natural.multiply(2, exponent, 1U << 28U, 28);
    natural.multiply(5, -exponent, 244'140'625U, 12);
    natural.write(digits, kExactDigits);
  }

  void write_to(char*& out) {
    const char* const first = std::find_if(value_, value_ + kExactDigits, is_not_zero);
    const auto begin = static_cast<std::size_t>(first - value_);
    std::size_t n = 1;
    while (n < kMostDigits && !shortened(begin, n)) ++n;
    if (n == kMostDigits) shortened(begin, n);
    // A carry may have put a digit in front.
    const std::size_t start = shortest_[begin - 1] != '0' ? begin - 1 : begin;
    n += begin - start;
    while (n > 1 && shortest_[start + n - 1] == '0') --n;
    const int point = static_cast<int>(kExactDigits - start) - scale_;  // digits before the point
    notate(out, shortest_ + start, static_cast<int>(n), point);
  }

  /// Rounds the value to `n` digits from `begin` into shortest_; true if that is in the interval.
  bool shortened(std::size_t begin, std::size_t n) {
    std::copy(value_, value_ + kExactDigits, shortest_);
    char* const cut = shortest_ + begin + n;
    char* const end = shortest_ + kExactDigits;
    bool up = false;
    if (cut < end) {
      const bool more = std::find_if(cut + 1, end, is_not_zero) != end;
      up = *cut > '5' || (*cut == '5' && (more || ((cut[-1] - '0') & 1) != 0));
      std::fill(cut, end, '0');
    }
    for (char* digit = cut - 1; up; --digit) {
      up = *digit == '9';
      *digit = up ? '0' : static_cast<char>(*digit + 1);
    }
    const int above_low = std::lexicographical_compare(low_, low_ + kExactDigits, shortest_, end);
    const int below_high =
        std::lexicographical_compare(shortest_, end, high_, high_ + kExactDigits);
    if (even_ && (above_low == 0 || below_high == 0)) {
      return std::equal(shortest_, end, low_) || std::equal(shortest_, end, high_);
    }
    return above_low != 0 && below_high != 0;
  }

  void notate(char*& out, const char* digits, int n, int point) const {
    const int exponent = point - 1;
    const int exponent_length = exponent <= -100 || exponent >= 100 ? 5 : 4;
    const int scientific = n + (n > 1 ? 1 : 0) + exponent_length;
    const int fixed = point <= 0 ? 2 - point + n : std::max(point, n + (point < n ? 1 : 0));
    if (fixed <= scientific) {
      // Whole numbers are written with their own digits, not with zeros.
      notate_fixed(out, point > n ? value_ + (digits - shortest_) : digits, n, point);
      return;
    }
    *out++ = digits[0];
    if (n > 1) *out++ = '.';
    out = std::copy(digits + 1, digits + n, out);
    *out++ = 'e';
    *out++ = exponent < 0 ? '-' : '+';
    const int magnitude = exponent < 0 ? -exponent : exponent;
    if (magnitude < 10) *out++ = '0';
    out += write_integer(out, magnitude);
  }

  static void notate_fixed(char*& out, const char* digits, int n, int point) {
    if (point <= 0) {
      append(out, "0.");
      out = std::fill_n(out, -point, '0');
      out = std::copy(digits, digits + n, out);
      return;
    }
    out = std::copy(digits, digits + point, out);
    if (point >= n) return;
    *out++ = '.';
    out = std::copy(digits + point, digits + n, out);
  }

  static bool is_not_zero(char digit) { return digit != '0'; }
  static void append(char*& out, const char* text) {
    while (*text != '\0') *out++ = *text++;
  }

  char value_[kExactDigits];
  char low_[kExactDigits];
  char high_[kExactDigits];
  char shortest_[kExactDigits];
  int scale_;
  bool even_;
};

}  // namespace eagerx::board
