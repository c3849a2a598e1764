// Prints the largest errors of the functions of eagerx/math.hpp, in units in the last place.
//   measure [count [seed]]    `count` arguments a function and type, against MPFR
//   measure every STEP        every STEP-th of all floats, against the host's functions in double
// The docstrings state what `measure 1000000` and `measure every 13` find, rounded up. Build with
//   g++ -std=c++20 -O2 -ffp-contract=off -fno-math-errno -Iruntime -I. tests/accuracy/measure.cpp
//       -o measure -lmpfr -lgmp
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "tests/accuracy/reference.hpp"

namespace {

using namespace eagerx::accuracy;

template <class T>
void print_worst(const char* type, std::uint64_t seed, int count) {
  const auto line = [&](const char* name, const Worst& worst) {
    std::printf("%-7s %-8s %.3f ulp at %a, %a\n", type, name, worst.ulp, worst.x, worst.y);
    std::fflush(stdout);
  };
  for (const auto& f : unary_functions<T>()) line(f.name, worst_of(f, seed, count));
  for (const auto& f : binary_functions<T>()) line(f.name, worst_of(f, seed, count));
  line("pow", worst_pow_of_all_sizes<T>(seed, count));
}

struct FloatPair {
  const char* name;
  float (*own)(float);
  double (*standard)(double);
};

/// As accuracy::ulp_error, with a reference of double precision.
double float_ulp_error(float computed, double exact) {
  constexpr double kOverflow = 0x1p128;
  if (std::isnan(exact) || std::isnan(computed)) {
    return std::isnan(exact) == std::isnan(computed) ? 0 : INFINITY;
  }
  if (std::abs(exact) >= kOverflow) {
    return computed == std::copysign(INFINITY, exact) ? 0 : INFINITY;
  }
  int exponent = 0;
  std::frexp(exact, &exponent);
  if (exponent < -125) exponent = -125;
  const double value =
      std::isinf(computed) ? std::copysign(kOverflow, computed) : static_cast<double>(computed);
  return std::ldexp(std::abs(value - exact), 24 - exponent);
}

void print_worst_of_every(std::uint32_t step) {
  const FloatPair pairs[] = {
      {"sin", eagerx::sin<float>, std::sin},
      {"cos", eagerx::cos<float>, std::cos},
      {"tan", eagerx::tan<float>, std::tan},
      {"asin", eagerx::asin<float>, std::asin},
      {"acos", eagerx::acos<float>, std::acos},
      {"atan", eagerx::atan<float>, std::atan},
      {"exp", eagerx::exp<float>, std::exp},
      {"log", eagerx::log<float>, std::log},
      {"log10", eagerx::log10<float>, std::log10},
      {"tanh", eagerx::tanh<float>, std::tanh},
      {"sinh", eagerx::sinh<float>, std::sinh},
      {"cosh", eagerx::cosh<float>, std::cosh},
      {"sigmoid", eagerx::sigmoid<float>, [](double x) { return 1 / (1 + std::exp(-x)); }}};
  for (const FloatPair& pair : pairs) {
    double worst = 0;
    float at = 0;
    for (std::uint64_t pattern = 0; pattern >> 32U == 0; pattern += step) {
      const float x = eagerx::unbits(static_cast<std::uint32_t>(pattern));
      const double ulp = float_ulp_error(pair.own(x), pair.standard(static_cast<double>(x)));
      if (ulp <= worst) continue;
      worst = ulp;
      at = x;
    }
    std::printf("float   %-8s %.3f ulp at %a\n", pair.name, worst, static_cast<double>(at));
    std::fflush(stdout);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 3 && std::strcmp(argv[1], "every") == 0) {
    print_worst_of_every(static_cast<std::uint32_t>(std::strtoul(argv[2], nullptr, 10)));
    return 0;
  }
  const int count = argc > 1 ? std::atoi(argv[1]) : 1000000;
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  print_worst<float>("float", seed, count);
  print_worst<double>("double", seed, count);
}
