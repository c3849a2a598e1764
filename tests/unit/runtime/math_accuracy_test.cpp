// Every function of eagerx/math.hpp against MPFR: no error above what its docstring states.
#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <type_traits>

#include "tests/accuracy/reference.hpp"

namespace eagerx::accuracy {
namespace {

constexpr int kArguments = 200'000;
constexpr std::uint64_t kSeed = 20231121;

struct Case {
  std::string name;
  double stated_ulp;
  Worst (*worst)(std::size_t index);
  std::size_t index;
};

void PrintTo(const Case& of, std::ostream* out) {
  *out << of.name;
}  // NOLINT: GoogleTest's name

std::string describe(const Worst& worst) {
  char text[96];
  std::snprintf(text, sizeof text, "%.3f ulp at (%a, %a)", worst.ulp, worst.x, worst.y);
  return text;
}

template <class T>
void add_cases(std::vector<Case>& cases, const std::string& type) {
  const auto worst_unary = [](std::size_t i) {
    return worst_of(unary_functions<T>()[i], kSeed, kArguments);
  };
  const auto worst_binary = [](std::size_t i) {
    return worst_of(binary_functions<T>()[i], kSeed, kArguments);
  };
  std::size_t index = 0;
  for (const Unary<T>& f : unary_functions<T>()) {
    cases.push_back({f.name + type, f.stated_ulp, worst_unary, index++});
  }
  index = 0;
  for (const Binary<T>& f : binary_functions<T>()) {
    cases.push_back({f.name + type, f.stated_ulp, worst_binary, index++});
  }
}

std::vector<Case> all_cases() {
  std::vector<Case> cases;
  add_cases<float>(cases, "_float");
  add_cases<double>(cases, "_double");
  return cases;
}

TEST(PowAccuracy, StaysWithinStatedErrorForResultsOfAllSizes) {
  const Worst of_float = worst_pow_of_all_sizes<float>(kSeed, kArguments);
  EXPECT_LE(of_float.ulp, binary_functions<float>().back().stated_ulp) << describe(of_float);
  const Worst of_double = worst_pow_of_all_sizes<double>(kSeed, kArguments);
  EXPECT_LE(of_double.ulp, binary_functions<double>().back().stated_ulp) << describe(of_double);
}

class MathAccuracy : public testing::TestWithParam<Case> {};

TEST_P(MathAccuracy, StaysWithinStatedError) {
  const Worst worst = GetParam().worst(GetParam().index);
  EXPECT_LE(worst.ulp, GetParam().stated_ulp) << describe(worst);
  EXPECT_GE(worst.ulp, 0.4) << "too good to have been measured: " << describe(worst);
}

INSTANTIATE_TEST_SUITE_P(Functions, MathAccuracy, testing::ValuesIn(all_cases()),
                         [](const auto& of) { return of.param.name; });

}  // namespace
}  // namespace eagerx::accuracy
