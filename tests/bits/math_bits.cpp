// One hash of what all functions of eagerx/math.hpp and eagerx/random.hpp, and the machine's own
// arithmetic and conversions, return for some thousand arguments: equal on every target, compiler
// and optimisation level, or something is wrong. A board defines EAGERX_NO_MAIN and calls
// math_bits_hash() itself.
#include <array>
#include <cstdint>
#include <eagerx/math.hpp>
#include <eagerx/random.hpp>
#include <eagerx/trace.hpp>

std::uint64_t math_bits_hash();

namespace {

using eagerx::BitsOf;

class Hash {
 public:
  template <class T>
  void fold(T value) {
    hash_ = (hash_ ^ eagerx::canonical_bits(value)) * kMultiplier;
    hash_ ^= hash_ >> 32U;
  }
  std::uint64_t value() const { return hash_; }

 private:
  static constexpr std::uint64_t kMultiplier = 0x9e3779b97f4a7c15U;
  std::uint64_t hash_ = 0xcbf29ce484222325U;
};

/// Two of four arguments are arbitrary bit patterns, the others from where the functions are used.
template <class T>
T argument(eagerx::Random& random, int i) {
  const std::uint64_t high = random.bits32();
  const auto pattern = static_cast<BitsOf<T>>((high << 32U) | random.bits32());
  const T quarter_turns = static_cast<T>(random.uniform(-10000, 10000)) * T(1.57079632679489662);
  switch (i % 4) {
    case 0:
      return random.uniform(T(-10), T(10));
    case 1:
      return quarter_turns;
    default:
      return eagerx::unbits(pattern);
  }
}

template <class T>
void fold_functions(Hash& hash, T x, T y) {
  const eagerx::SinCos<T> both = eagerx::sincos(x);
  const std::array<T, 27> results = {both.sin,
                                     both.cos,
                                     eagerx::sin(y),
                                     eagerx::cos(y),
                                     eagerx::tan(x),
                                     eagerx::asin(x),
                                     eagerx::acos(x),
                                     eagerx::atan(x),
                                     eagerx::atan2(y, x),
                                     eagerx::exp(x),
                                     eagerx::log(x),
                                     eagerx::log10(x),
                                     eagerx::tanh(x),
                                     eagerx::sinh(x),
                                     eagerx::cosh(x),
                                     eagerx::sigmoid(x),
                                     eagerx::sqrt(x),
                                     eagerx::pow(x, y),
                                     eagerx::pow(eagerx::abs(x), y),
                                     eagerx::floor(x),
                                     eagerx::ceil(x),
                                     eagerx::trunc(x),
                                     eagerx::round(x),
                                     eagerx::fmod(x, y),
                                     eagerx::min(x, y),
                                     eagerx::max(x, y),
                                     eagerx::clamp(x, T(-1), T(1))};
  for (const T result : results) hash.fold(result);
}

template <class T>
void fold_arithmetic(Hash& hash, T x, T y) {
  const std::array<T, 4> results = {x + y, x - y, x * y, x / y};
  for (const T result : results) hash.fold(result);
}

/// Conversions: boards do some of them in software.
template <class T>
void fold_conversions(Hash& hash, eagerx::Random& random, T x) {
  const std::uint64_t wide = (std::uint64_t{random.bits32()} << 32U) | random.bits32();
  const std::uint64_t shorter = wide >> random.below(64);
  hash.fold(static_cast<T>(shorter));
  hash.fold(static_cast<T>(static_cast<std::int64_t>(wide)));
  hash.fold(static_cast<T>(static_cast<std::int32_t>(shorter)));
  hash.fold(static_cast<float>(x));
  hash.fold(static_cast<double>(x));
  const T small = eagerx::clamp(x, T(-1000000), T(1000000));
  hash.fold(eagerx::isnan(x) ? 0 : static_cast<std::int32_t>(small));
  hash.fold(eagerx::isnan(x) ? std::int64_t{0} : static_cast<std::int64_t>(small));
}

template <class T>
void fold_random(Hash& hash, eagerx::Random& random) {
  hash.fold(random.uniform(T(-3), T(7)));
  hash.fold(random.normal(T(1), T(2)));
  hash.fold(random.log_uniform(T(0.001), T(1000)));
}

template <class T>
void fold_all(Hash& hash) {
  constexpr int kArguments = 4096;
  eagerx::Random random({2024, 1, 2}, eagerx::entity_id("tests/bits"));
  for (int i = 0; i < kArguments; ++i) {
    const T x = argument<T>(random, i);
    const T y = argument<T>(random, i / 4);
    fold_functions(hash, x, y);
    fold_arithmetic(hash, x, y);
    fold_arithmetic(hash, x, x * T(1.1641532182693481e-10));  // 33 binary places apart
    fold_conversions(hash, random, x);
    fold_random<T>(hash, random);
    hash.fold(random.uniform(-5, 5));
    hash.fold(random.uniform(std::int64_t{-5'000'000'000}, std::int64_t{5'000'000'000}));
  }
}

}  // namespace

std::uint64_t math_bits_hash() {
  Hash hash;
  fold_all<float>(hash);
  fold_all<double>(hash);
  return hash.value();
}

#ifndef EAGERX_NO_MAIN
#include <cinttypes>
#include <cstdio>

int main() {
  std::printf("%016" PRIx64 "\n", math_bits_hash());
}
#endif
