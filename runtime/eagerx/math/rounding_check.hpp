// Finds compiler options that may change results. Macros reveal -ffast-math and, with g++, most of
// its parts (vocabulary.hpp rejects these); clang has no macros for the parts.
#pragma once

namespace eagerx {

/// False if the compiler fuses products and sums in this translation unit (-ffp-contract=fast, if
/// the machine has such instructions), reorders sums (-fassociative-math), or turns quotients into
/// products (-freciprocal-math). Each translation unit has its own copy, because each has its own
/// flags.
[[nodiscard, maybe_unused]] static bool rounds_each_operation() {
  // Read at run time; otherwise the compiler would compute the result without applying the flags.
  volatile float factor = 1.000244140625F;  // 1 + 2^-12, its square rounds to 1 + 2^-11
  volatile float square = 1.00048828125F;
  volatile float large = 16777216.0F;  // 2^24, to which 1 adds nothing
  volatile float small = 1.0F;
  volatile float five = 5.0F;
  const float x = factor;
  const float a = large;
  const float b = small;
  const float sum = a + b;
  const float product = x * x;
  const float y = factor;
  // In two statements (fast), and in one (on).
  const bool contracts = product - square != 0.0F || y * y - square != 0.0F;
  const bool reorders = sum - a != 0.0F;
  const bool multiplies = five / 3.0F != 1.66666663F;  // times 0.333333343 it is 1.66666675
  return !contracts && !reorders && !multiplies;
}

}  // namespace eagerx
