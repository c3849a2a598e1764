// Exact fractions, for time: a rate of 29.97 Hz is 2997/100, a period of 30 Hz is 1/30 s.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace eagerx::gen {

/// A fraction of two 64 bit integers in lowest terms, or "overflowed" when a result does not fit or
/// was divided by zero. Overflow persists through every operation, so check it only once, at the
/// end.
class Rational {
 public:
  constexpr Rational() = default;
  /// A whole number.
  constexpr Rational(std::int64_t whole) : num_(whole) {}  // NOLINT(google-explicit-constructor)
  /// num/den in lowest terms; den may be negative, 0 gives overflowed.
  Rational(std::int64_t num, std::int64_t den);

  /// Reads "30", "-0.07", "29.97", "1e-3", "30000/1001", exactly. Nothing for other texts (blanks,
  /// leading zeros, ".inf", a zero denominator) and for numbers that do not fit.
  static std::optional<Rational> parse(std::string_view text);
  /// The shortest decimal that means `real`; nothing if it does not fit.
  static std::optional<Rational> of_decimal(double real);
  /// The caller vouches that den > 0 and that num and den have no common factor.
  static Rational from_lowest_terms(std::int64_t num, std::int64_t den);

  [[nodiscard]] constexpr std::int64_t num() const { return num_; }
  [[nodiscard]] constexpr std::int64_t den() const { return den_; }  // > 0; 0: overflowed
  [[nodiscard]] constexpr bool overflowed() const { return den_ == 0; }
  [[nodiscard]] constexpr bool is_integer() const { return den_ == 1; }

  /// Largest whole number not above, smallest not below; 0 when overflowed.
  [[nodiscard]] std::int64_t floor() const;
  [[nodiscard]] std::int64_t ceil() const;
  /// The nearest double; NaN when overflowed.
  [[nodiscard]] double to_double() const;
  /// "30", "29.97"; "30/7" when the decimals do not end (or only after more than 18); "overflow".
  /// parse() gives the same number back.
  [[nodiscard]] std::string to_string() const;

  friend Rational operator+(const Rational& a, const Rational& b);
  friend Rational operator-(const Rational& a, const Rational& b);
  friend Rational operator*(const Rational& a, const Rational& b);
  friend Rational operator/(const Rational& a, const Rational& b);
  Rational operator-() const { return Rational() - *this; }

  /// Overflowed is unordered: neither equal to, less nor greater than anything.
  friend std::partial_ordering operator<=>(const Rational& a, const Rational& b);
  friend bool operator==(const Rational& a, const Rational& b) { return (a <=> b) == 0; }

 private:
  std::int64_t num_ = 0;
  std::int64_t den_ = 1;
};

/// The largest number that both are whole multiples of; never negative. gcd(0, b) = |b|.
Rational gcd(const Rational& a, const Rational& b);
/// The smallest positive number that is a whole multiple of both; 0 if one is 0.
Rational lcm(const Rational& a, const Rational& b);

}  // namespace eagerx::gen
