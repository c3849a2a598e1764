// Errors of eagerx/math.hpp in units in the last place, with MPFR as the reference.
#pragma once

#include <mpfr.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <eagerx/math.hpp>
#include <eagerx/random.hpp>
#include <limits>
#include <vector>

namespace eagerx::accuracy {

/// An MPFR number with enough digits to measure errors of a double to a thousandth of an ulp.
class Exact {
 public:
  Exact() { mpfr_init2(value_, kPrecision); }
  ~Exact() { mpfr_clear(value_); }
  Exact(const Exact&) = delete;
  Exact& operator=(const Exact&) = delete;
  mpfr_ptr get() { return value_; }
  mpfr_srcptr get() const { return value_; }

 private:
  static constexpr mpfr_prec_t kPrecision = 96;
  mpfr_t value_;
};

/// |computed - exact| in units in the last place of `exact`; 0 if both are NaN or the same
/// infinity, infinity if only one is. An infinite `computed` is right from half an ulp above the
/// largest number.
template <class T>
double ulp_error(T computed, const Exact& exact) {
  constexpr double kWrong = std::numeric_limits<double>::infinity();
  constexpr int kMaxExponent = std::numeric_limits<T>::max_exponent;
  if (mpfr_nan_p(exact.get()) != 0 || computed != computed) {
    return (mpfr_nan_p(exact.get()) != 0) == (computed != computed) ? 0.0 : kWrong;
  }
  if (mpfr_inf_p(exact.get()) != 0) {
    const T infinity = std::numeric_limits<T>::infinity();
    return computed == (mpfr_sgn(exact.get()) > 0 ? infinity : -infinity) ? 0.0 : kWrong;
  }
  Exact difference;
  if (computed - computed == 0) {
    mpfr_set_d(difference.get(), static_cast<double>(computed), MPFR_RNDN);
  } else {  // infinity counts as the number that would follow the largest
    mpfr_set_si_2exp(difference.get(), computed > 0 ? 1 : -1, kMaxExponent, MPFR_RNDN);
    if (mpfr_cmpabs(exact.get(), difference.get()) >= 0) {
      return (mpfr_sgn(exact.get()) > 0) == (computed > 0) ? 0.0 : kWrong;
    }
  }
  mpfr_sub(difference.get(), difference.get(), exact.get(), MPFR_RNDN);
  const long exponent = mpfr_zero_p(exact.get()) != 0 ? std::numeric_limits<T>::min_exponent
                                                      : mpfr_get_exp(exact.get());
  const long ulp = std::clamp<long>(exponent, std::numeric_limits<T>::min_exponent, kMaxExponent) -
                   std::numeric_limits<T>::digits;
  mpfr_mul_2si(difference.get(), difference.get(), -ulp, MPFR_RNDN);
  return mpfr_get_d(difference.get(), MPFR_RNDA) < 0 ? -mpfr_get_d(difference.get(), MPFR_RNDA)
                                                     : mpfr_get_d(difference.get(), MPFR_RNDA);
}

/// A function of one number, its reference, and the largest error its docstring states.
template <class T>
struct Unary {
  const char* name;
  T (*own)(T);
  int (*exact)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);
  double stated_ulp;
  T usual;  ///< arguments within ±usual are the ones that matter most
};

template <class T>
struct Binary {
  const char* name;
  T (*own)(T, T);
  int (*exact)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);
  double stated_ulp;
  T usual;
};

inline int exact_sigmoid(mpfr_ptr result, mpfr_srcptr x, mpfr_rnd_t rounding) {
  mpfr_neg(result, x, rounding);
  mpfr_exp(result, result, rounding);
  mpfr_add_ui(result, result, 1, rounding);
  return mpfr_ui_div(result, 1, result, rounding);
}

template <class T>
const std::vector<Unary<T>>& unary_functions() {
  // float, double
  const auto stated = [](double of_float, double of_double) {
    return sizeof(T) == 4 ? of_float : of_double;
  };
  static const std::vector<Unary<T>> functions = {
      {"sin", eagerx::sin<T>, mpfr_sin, stated(0.95, 0.9), T(10)},
      {"cos", eagerx::cos<T>, mpfr_cos, stated(0.95, 0.9), T(10)},
      {"tan", eagerx::tan<T>, mpfr_tan, stated(2.6, 2.4), T(10)},
      {"asin", eagerx::asin<T>, mpfr_asin, stated(2.4, 2.4), T(1)},
      {"acos", eagerx::acos<T>, mpfr_acos, stated(1.25, 1.25), T(1)},
      {"atan", eagerx::atan<T>, mpfr_atan, stated(2.4, 2.4), T(5)},
      {"exp", eagerx::exp<T>, mpfr_exp, stated(1.05, 1.0), stated(105, 745)},
      {"log", eagerx::log<T>, mpfr_log, stated(0.85, 0.85), T(3)},
      {"log10", eagerx::log10<T>, mpfr_log10, stated(0.75, 0.75), T(3)},
      {"tanh", eagerx::tanh<T>, mpfr_tanh, stated(2.7, 2.5), T(5)},
      {"sinh", eagerx::sinh<T>, mpfr_sinh, stated(2.5, 2.5), T(5)},
      {"cosh", eagerx::cosh<T>, mpfr_cosh, stated(1.6, 1.6), T(5)},
      {"sigmoid", eagerx::sigmoid<T>, exact_sigmoid, stated(2.5, 2.5), T(20)},
      {"sqrt", [](T x) { return eagerx::sqrt(x); }, mpfr_sqrt, 0.5, T(10)},
  };
  return functions;
}

template <class T>
const std::vector<Binary<T>>& binary_functions() {
  static const std::vector<Binary<T>> functions = {
      {"atan2", eagerx::atan2<T>, mpfr_atan2, 2.4, T(5)},
      {"pow", eagerx::pow<T>, mpfr_pow, sizeof(T) == 4 ? 1.2 : 3.0, T(10)},
  };
  return functions;
}

/// Arguments that find errors: arbitrary bit patterns, the usual range, all small exponents, and
/// numbers next to multiples of pi/2 (or, for other functions, next to other halves and wholes).
template <class T>
class Arguments {
 public:
  explicit Arguments(std::uint64_t seed) : random_({seed, 0, 0}, entity_id("arguments")) {}

  T next(T usual) {
    switch (count_++ % 5) {
      case 0:
        return arbitrary();
      case 1:
        return random_.uniform(-usual, usual);
      case 2:
        return signed_(random_.log_uniform(T(0x1p-40), T(0x1p+12)));
      case 3:
        return moved(static_cast<T>(static_cast<double>(random_.uniform(1, 20000)) * kHalfPi));
      default:
        return moved(signed_(static_cast<T>(random_.uniform(0, 40)) * T(0.125)));
    }
  }

 private:
  static constexpr double kHalfPi = 1.5707963267948966;

  T arbitrary() {
    const std::uint64_t high = random_.bits32();
    return unbits(static_cast<BitsOf<T>>((high << 32U) | random_.bits32()));
  }
  T signed_(T magnitude) { return random_.uniform(false, true) ? magnitude : -magnitude; }
  /// Some places up or down.
  T moved(T x) {
    if (random_.below(2) == 0) x = -x;
    return unbits(bits(x) + static_cast<BitsOf<T>>(random_.uniform(-3, 3)));
  }

  Random random_;
  unsigned count_ = 0;
};

/// The arguments that come closest to a multiple of pi/2, relative to their last place.
template <class T>
constexpr T kHardestAngle = sizeof(T) == 4 ? T(0x1.f37a0ap+95F) : T(0x1.6ac5b262ca1ffp+849);

struct Worst {
  double ulp = 0;
  double x = 0;
  double y = 0;
};

template <class T>
void measure(Worst& worst, const Unary<T>& function, T x) {
  Exact argument;
  Exact exact;
  mpfr_set_d(argument.get(), static_cast<double>(x), MPFR_RNDN);
  function.exact(exact.get(), argument.get(), MPFR_RNDN);
  const double ulp = ulp_error(function.own(x), exact);
  if (!(ulp <= worst.ulp)) worst = {ulp, static_cast<double>(x), 0};
}

template <class T>
void measure(Worst& worst, const Binary<T>& function, T x, T y) {
  Exact first;
  Exact second;
  Exact exact;
  mpfr_set_d(first.get(), static_cast<double>(x), MPFR_RNDN);
  mpfr_set_d(second.get(), static_cast<double>(y), MPFR_RNDN);
  function.exact(exact.get(), first.get(), second.get(), MPFR_RNDN);
  const double ulp = ulp_error(function.own(x, y), exact);
  if (!(ulp <= worst.ulp)) worst = {ulp, static_cast<double>(x), static_cast<double>(y)};
}

template <class T>
Worst worst_of(const Unary<T>& function, std::uint64_t seed, int count) {
  Worst worst;
  measure(worst, function, kHardestAngle<T>);
  Arguments<T> arguments(seed);
  for (int i = 0; i < count; ++i) measure(worst, function, arguments.next(function.usual));
  return worst;
}

template <class T>
Worst worst_of(const Binary<T>& function, std::uint64_t seed, int count) {
  Worst worst;
  Arguments<T> first(seed);
  Arguments<T> second(~seed);
  Random random({seed, 1, 0}, entity_id("order"));
  for (int i = 0; i < count; ++i) {
    for (std::uint32_t skipped = random.below(3); skipped > 0; --skipped)
      second.next(function.usual);
    measure(worst, function, first.next(function.usual), second.next(function.usual));
  }
  return worst;
}

/// pow where it is hardest: results of all sizes up to the largest and smallest, by any bases.
template <class T>
Worst worst_pow_of_all_sizes(std::uint64_t seed, int count) {
  const Binary<T>& pow = binary_functions<T>().back();
  const T largest_log = sizeof(T) == 4 ? T(88) : T(709);
  Worst worst;
  Random random({seed, 2, 0}, entity_id("pow"));
  for (int i = 0; i < count; ++i) {
    const T x = i % 2 == 0 ? random.log_uniform(T(0.001), T(1000)) : random.uniform(T(0.5), T(2));
    if (x != T(1)) measure(worst, pow, x, random.uniform(-largest_log, largest_log) / log(x));
  }
  return worst;
}

}  // namespace eagerx::accuracy
