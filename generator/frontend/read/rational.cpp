#include "generator/frontend/read/rational.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <numeric>

#include "generator/frontend/read/scalar.hpp"

namespace eagerx::gen {
namespace {

__extension__ using Wide =
    __int128;  // products of two 64 bit numbers fit, and the sum of two of them

constexpr int kBase = 10;
constexpr int kMaxDecimals = 18;    // 10^18 < 2^63
constexpr int kMaxWideDigits = 37;  // 10^37 < 2^127 / 10

Wide gcd_wide(Wide a, Wide b) {
  while (b != 0) {
    const Wide rest = a % b;
    a = b;
    b = rest;
  }
  return a < 0 ? -a : a;
}

bool fits(Wide value) {
  return value >= std::numeric_limits<std::int64_t>::min() &&
         value <= std::numeric_limits<std::int64_t>::max();
}

/// num/den in lowest terms.
Rational reduce(Wide num, Wide den) {
  const Rational overflowed(0, 0);
  if (den == 0) return overflowed;
  const Wide divisor = gcd_wide(num, den) * (den < 0 ? -1 : 1);
  num /= divisor;
  den /= divisor;
  if (!fits(num) || !fits(den)) return overflowed;
  return Rational::from_lowest_terms(static_cast<std::int64_t>(num),
                                     static_cast<std::int64_t>(den));
}

bool either_overflowed(const Rational& a, const Rational& b) {
  return a.overflowed() || b.overflowed();
}

Wide power_of_ten(int exponent) {
  Wide power = 1;
  for (int i = 0; i < exponent; ++i) power *= kBase;
  return power;
}

/// A decimal taken apart: digits * 10^exponent.
struct Decimal {
  bool negative = false;
  std::string digits;  // without zeros at either end; empty: zero
  std::int64_t exponent = 0;
};

/// `text` has been checked to be a decimal number.
std::optional<Decimal> take_apart(std::string_view text) {
  Decimal decimal;
  decimal.negative = text.starts_with('-');
  const std::size_t e = std::min(text.find_first_of("eE"), text.size());
  if (e < text.size()) {
    std::string_view exponent = text.substr(e + 1);
    const bool signed_exponent = exponent[0] == '-' || exponent[0] == '+';
    const bool negative = exponent[0] == '-';
    if (signed_exponent) exponent.remove_prefix(1);
    exponent.remove_prefix(std::min(exponent.find_first_not_of('0'), exponent.size() - 1));
    const auto value = parse_int(exponent);
    // No number of this size is written by a person; keeps the sums below from overflowing.
    constexpr std::int64_t kMaxExponent = 1'000'000'000;
    if (!value || *value > kMaxExponent) return std::nullopt;
    decimal.exponent = negative ? -*value : *value;
  }
  bool after_point = false;
  for (const char c : text.substr(0, e)) {
    if (c == '.') after_point = true;
    if (c < '0' || c > '9') continue;
    decimal.digits += c;
    if (after_point) --decimal.exponent;
  }
  while (decimal.digits.ends_with('0')) {
    decimal.digits.pop_back();
    ++decimal.exponent;
  }
  decimal.digits.erase(0, std::min(decimal.digits.find_first_not_of('0'), decimal.digits.size()));
  return decimal;
}

std::optional<Rational> parse_decimal(std::string_view text) {
  const auto decimal = take_apart(text);
  if (!decimal) return std::nullopt;
  if (decimal->digits.empty()) return Rational();
  if (decimal->digits.size() > kMaxWideDigits) return std::nullopt;
  Wide num = 0;
  for (const char c : decimal->digits) num = num * kBase + (c - '0');
  if (decimal->negative) num = -num;
  const auto digits = static_cast<std::int64_t>(decimal->digits.size());
  if (decimal->exponent > kMaxWideDigits - digits || decimal->exponent < -kMaxWideDigits) {
    return std::nullopt;
  }
  const auto exponent = static_cast<int>(decimal->exponent);
  const Rational result = exponent >= 0 ? reduce(num * power_of_ten(exponent), 1)
                                        : reduce(num, power_of_ten(-exponent));
  return result.overflowed() ? std::nullopt : std::optional(result);
}

std::optional<Rational> parse_fraction(std::string_view text, std::size_t slash) {
  const auto num = parse_int(text.substr(0, slash));
  const auto den = parse_int(text.substr(slash + 1));
  if (!num || !den) return std::nullopt;
  const Rational result(*num, *den);
  return result.overflowed() ? std::nullopt : std::optional(result);
}

/// How often `factor` divides `value`; divides it out.
int take_factor(std::int64_t& value, std::int64_t factor) {
  int count = 0;
  for (; value % factor == 0; value /= factor) ++count;
  return count;
}

std::string digits_of(Wide value) {
  std::string digits;
  for (; value > 0; value /= kBase)
    digits += static_cast<char>('0' + static_cast<int>(value % kBase));
  std::reverse(digits.begin(), digits.end());
  return digits;
}

}  // namespace

Rational Rational::from_lowest_terms(std::int64_t num, std::int64_t den) {
  Rational result;
  result.num_ = num;
  result.den_ = den;
  return result;
}

Rational::Rational(std::int64_t num, std::int64_t den) {
  if (den == 0) {
    den_ = 0;
  } else {
    *this = reduce(num, den);
  }
}

std::optional<Rational> Rational::parse(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash != std::string_view::npos) return parse_fraction(text, slash);
  return is_decimal_text(text) ? parse_decimal(text) : std::nullopt;
}

std::optional<Rational> Rational::of_decimal(double real) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), real).ptr;
  return parse({digits.data(), static_cast<std::size_t>(end - digits.data())});
}

Rational operator+(const Rational& a, const Rational& b) {
  if (either_overflowed(a, b)) return {0, 0};
  return reduce(Wide{a.num_} * b.den_ + Wide{b.num_} * a.den_, Wide{a.den_} * b.den_);
}

Rational operator-(const Rational& a, const Rational& b) {
  if (either_overflowed(a, b)) return {0, 0};
  return reduce(Wide{a.num_} * b.den_ - Wide{b.num_} * a.den_, Wide{a.den_} * b.den_);
}

Rational operator*(const Rational& a, const Rational& b) {
  if (either_overflowed(a, b)) return {0, 0};
  return reduce(Wide{a.num_} * b.num_, Wide{a.den_} * b.den_);
}

Rational operator/(const Rational& a, const Rational& b) {
  if (either_overflowed(a, b)) return {0, 0};
  return reduce(Wide{a.num_} * b.den_, Wide{a.den_} * b.num_);
}

std::partial_ordering operator<=>(const Rational& a, const Rational& b) {
  if (either_overflowed(a, b)) return std::partial_ordering::unordered;
  const Wide left = Wide{a.num_} * b.den_;
  const Wide right = Wide{b.num_} * a.den_;
  if (left < right) return std::partial_ordering::less;
  return left > right ? std::partial_ordering::greater : std::partial_ordering::equivalent;
}

std::int64_t Rational::floor() const {
  if (overflowed()) return 0;
  return num_ / den_ - (num_ % den_ < 0 ? 1 : 0);
}

std::int64_t Rational::ceil() const {
  if (overflowed()) return 0;
  return num_ / den_ + (num_ % den_ > 0 ? 1 : 0);
}

double Rational::to_double() const {
  if (overflowed()) return std::numeric_limits<double>::quiet_NaN();
  constexpr Wide kExact = Wide{1} << 53;
  const Wide magnitude = num_ < 0 ? -Wide{num_} : Wide{num_};
  // Both are exact up to 2^53, which gives the nearest double: one rounding, in the division.
  if (magnitude <= kExact && den_ <= kExact)
    return static_cast<double>(num_) / static_cast<double>(den_);
  // Else of more bits than a double has; the last one says whether there are others behind it.
  constexpr int kBits = 56;
  const auto bits = [](Wide value) {
    return static_cast<int>(std::bit_width(static_cast<std::uint64_t>(value)));
  };
  const int shift = std::max(0, kBits + bits(den_) - bits(magnitude));
  const Wide scaled = magnitude << shift;
  const auto quotient = static_cast<std::uint64_t>(scaled / den_) | (scaled % den_ != 0 ? 1U : 0U);
  const double nearest = std::ldexp(static_cast<double>(quotient), -shift);
  return num_ < 0 ? -nearest : nearest;
}

std::string Rational::to_string() const {
  if (overflowed()) return "overflow";
  if (is_integer()) return std::to_string(num_);
  std::int64_t rest = den_;
  const int decimals = std::max(take_factor(rest, 2), take_factor(rest, 5));
  if (rest != 1 || decimals > kMaxDecimals) {
    return std::to_string(num_) + "/" + std::to_string(den_);
  }
  const Wide scaled = Wide{num_} * (power_of_ten(decimals) / den_);
  std::string digits = digits_of(scaled < 0 ? -scaled : scaled);
  const auto places = static_cast<std::size_t>(decimals);
  if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
  digits.insert(digits.size() - places, ".");
  return (num_ < 0 ? "-" : "") + digits;
}

Rational gcd(const Rational& a, const Rational& b) {
  if (either_overflowed(a, b)) return {0, 0};
  const Wide left = Wide{a.num()} * b.den();
  const Wide right = Wide{b.num()} * a.den();
  return reduce(gcd_wide(left, right), Wide{a.den()} * b.den());
}

Rational lcm(const Rational& a, const Rational& b) {
  if (either_overflowed(a, b)) return {0, 0};
  if (a == 0 || b == 0) return {};
  const Rational product = a / gcd(a, b) * b;
  return product < 0 ? -product : product;
}

}  // namespace eagerx::gen
