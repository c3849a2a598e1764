// Rows of eight-bit weights times inputs that were rounded to 16 bits: the same bits with the
// instructions of a Cortex-M4, with those of x86, and as plain loops.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#if defined(__ARM_FEATURE_SIMD32) && defined(__thumb2__)
#define EAGERX_POLICY_HALFWORDS 1
#else
#define EAGERX_POLICY_HALFWORDS 0
#endif

namespace eagerx::policy {

/// Bytes of a row of weights: whole words.
constexpr std::size_t int8_row(std::size_t inputs) {
  return (inputs + 3) / 4 * 4;
}

constexpr std::size_t int8_index(std::size_t inputs, std::size_t outputs, std::size_t out,
                                 std::size_t in) {
  const std::size_t row = int8_row(inputs);
  if (out >= outputs / 4 * 4) return out * row + in;
  return out / 4 * 4 * row + in / 4 * 16 + out % 4 * 4 + in % 4;
}

/// The largest rounded input for which no sum of `inputs` products with weights up to 127 overflows
/// 32 bits.
constexpr std::int32_t int8_limit(std::size_t inputs) {
  constexpr std::int32_t kMost = 32767;
  const auto fits = static_cast<std::int32_t>(0x7fffffffU / (127U * inputs));
  return fits < kMost ? fits : kMost;
}

/// Index of input `i` among the rounded ones. A Cortex-M4 widens the even and the odd bytes of a
/// word, so the second and the third of four are swapped.
constexpr std::size_t int8_place(std::size_t i) {
  if (EAGERX_POLICY_HALFWORDS == 0) return i;
  return (i & ~std::size_t{3}) | ((i & 1U) << 1U) | ((i >> 1U) & 1U);
}

/// x [inputs] as whole numbers q [int8_row(inputs)] times the number returned, rounded to nearest,
/// ties to even. NaN if any input is not a finite number; 0 if all are below 1e-30.
[[gnu::noinline]] inline float round_inputs(const float* x, std::size_t inputs, std::int16_t* q) {
  constexpr std::uint32_t kInfinity = 0x7f800000U;
  constexpr std::uint32_t kSmallest = std::bit_cast<std::uint32_t>(1e-30F);
  constexpr float kRounder = 0x1.8p23F;  // x + kRounder has the whole number x in its low bits
  std::uint32_t largest = 0;             // magnitudes are in the order of their bits, NaN on top
  for (std::size_t i = 0; i < inputs; ++i) {
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(x[i]) << 1U;
    largest = largest < bits ? bits : largest;
  }
  largest >>= 1U;
  if (largest < kSmallest || largest >= kInfinity) {
    std::memset(q, 0, int8_row(inputs) * sizeof *q);
    return largest < kSmallest ? 0.0F : std::bit_cast<float>(0x7fc00000U);
  }
  const auto rounded = [factor = static_cast<float>(int8_limit(inputs)) /
                                 std::bit_cast<float>(largest)](float value) {
    return static_cast<std::int16_t>(std::bit_cast<std::uint32_t>(value * factor + kRounder));
  };
  const std::size_t whole = inputs & ~std::size_t{3};
  for (std::size_t i = 0; i < whole; i += 4) {
    for (std::size_t k = 0; k < 4; ++k) q[i + int8_place(k)] = rounded(x[i + k]);
  }
  const std::size_t rest = inputs & 3U;
  for (std::size_t k = 0; k < rest; ++k) q[whole + int8_place(k)] = rounded(x[whole + k]);
  if (rest > 0) {
    for (std::size_t k = rest; k < 4; ++k) q[whole + int8_place(k)] = 0;
  }
  return std::bit_cast<float>(largest) / static_cast<float>(int8_limit(inputs));
}

/// An output from its sum of products.
[[gnu::always_inline]] inline float int8_output(float b, float scale, float step,
                                                std::int32_t sum) {
  return b + (scale * step) * static_cast<float>(sum);
}

#if EAGERX_POLICY_HALFWORDS

/// The sums of four rows: the products of the `words` words of each, four rows after one another.
[[gnu::always_inline]] inline void add_rows(const std::int8_t*& w, const std::int16_t* q,
                                            std::size_t words, std::int32_t (&sums)[4]) {
  std::int32_t a = 0;
  std::int32_t b = 0;
  std::int32_t c = 0;
  std::int32_t d = 0;
  std::uint32_t first;
  std::uint32_t second;
  std::uint32_t wide;
  // The sums never overflow, so the flag that `smlad` sets does not matter.
  // clang-format off
#define EAGERX_POLICY_ROW(word, sum)             \
  "sxtb16 %[wide], " word "\n"                   \
  "smlad " sum ", %[wide], r4, " sum "\n"        \
  "sxtb16 " word ", " word ", ror #8\n"          \
  "smlad " sum ", " word ", r5, " sum "\n"
  asm volatile(
      "1:\n"
      "ldrd r4, r5, [%[q]], #8\n"
      "ldr %[first], [%[w]], #4\n ldr %[second], [%[w]], #4\n"
      EAGERX_POLICY_ROW("%[first]", "%[a]") EAGERX_POLICY_ROW("%[second]", "%[b]")
      "ldr %[first], [%[w]], #4\n ldr %[second], [%[w]], #4\n"
      EAGERX_POLICY_ROW("%[first]", "%[c]") EAGERX_POLICY_ROW("%[second]", "%[d]")
      "subs %[words], #1\n"
      "bne 1b\n"
      : [w] "+r"(w), [q] "+r"(q), [words] "+l"(words), [a] "+r"(a), [b] "+r"(b), [c] "+r"(c),
        [d] "+r"(d), [first] "=&r"(first), [second] "=&r"(second), [wide] "=&r"(wide)
      :
      : "cc", "memory", "r4", "r5");
#undef EAGERX_POLICY_ROW
  // clang-format on
  sums[0] = a;
  sums[1] = b;
  sums[2] = c;
  sums[3] = d;
}

/// The sum of one row of `words` words.
[[gnu::always_inline]] inline std::int32_t add_row(const std::int8_t* w, const std::int16_t* q,
                                                   std::size_t words) {
  std::int32_t sum = 0;
  std::uint32_t word;
  std::uint32_t wide;
  // clang-format off
  asm volatile(
      "1:\n"
      "ldrd r4, r5, [%[q]], #8\n"
      "ldr %[word], [%[w]], #4\n"
      "sxtb16 %[wide], %[word]\n smlad %[sum], %[wide], r4, %[sum]\n"
      "sxtb16 %[wide], %[word], ror #8\n smlad %[sum], %[wide], r5, %[sum]\n"
      "subs %[words], #1\n"
      "bne 1b\n"
      : [w] "+r"(w), [q] "+r"(q), [words] "+l"(words), [sum] "+r"(sum), [word] "=&r"(word),
        [wide] "=&r"(wide)
      :
      : "cc", "memory", "r4", "r5");
  // clang-format on
  return sum;
}

#else

[[gnu::always_inline]] inline std::int32_t add_row(const std::int8_t* w, const std::int16_t* q,
                                                   std::size_t words) {
  std::int32_t sum = 0;
  for (std::size_t i = 0; i < 4 * words; ++i) sum += std::int32_t{w[i]} * std::int32_t{q[i]};
  return sum;
}

[[gnu::always_inline]] inline void add_rows(const std::int8_t*& w, const std::int16_t* q,
                                            std::size_t words, std::int32_t (&sums)[4]) {
#if defined(__SSE2__)
  using Bytes [[gnu::vector_size(8)]] = std::int8_t;
  using Words [[gnu::vector_size(16)]] = std::int16_t;
  using Inputs [[gnu::vector_size(16)]] = std::int64_t;
  using Sums [[gnu::vector_size(16)]] = std::int32_t;
  Sums low = {};
  Sums high = {};
  for (std::size_t i = 0; i < words; ++i, w += 16) {
    Bytes bytes[2];
    std::int64_t four = 0;
    std::memcpy(bytes, w, sizeof bytes);
    std::memcpy(&four, q + 4 * i, sizeof four);
    const auto inputs = std::bit_cast<Words>(Inputs{four, four});
    low += __builtin_ia32_pmaddwd128(__builtin_convertvector(bytes[0], Words), inputs);
    high += __builtin_ia32_pmaddwd128(__builtin_convertvector(bytes[1], Words), inputs);
  }
  sums[0] = low[0] + low[1];
  sums[1] = low[2] + low[3];
  sums[2] = high[0] + high[1];
  sums[3] = high[2] + high[3];
#else
  for (std::int32_t& sum : sums) sum = 0;
  for (std::size_t i = 0; i < words; ++i) {
    for (std::int32_t& sum : sums) {
      for (std::size_t k = 0; k < 4; ++k) sum += std::int32_t{*w++} * std::int32_t{q[4 * i + k]};
    }
  }
#endif
}

#endif

/// y [outputs] = b + scale step (w q) with w as int8_index() says.
[[gnu::noinline]] inline void int8_rows(const std::int8_t* w, const float* scale, const float* b,
                                        const std::int16_t* q, float step, float* y,
                                        std::size_t inputs, std::size_t outputs) {
  const std::size_t words = int8_row(inputs) / 4;
  const std::size_t whole = outputs & ~std::size_t{3};
  for (std::size_t out = 0; out < whole; out += 4) {
    std::int32_t sums[4];
    add_rows(w, q, words, sums);
    for (std::size_t k = 0; k < 4; ++k) {
      y[out + k] = int8_output(b[out + k], scale[out + k], step, sums[k]);
    }
  }
  for (std::size_t out = whole; out < outputs; ++out) {
    y[out] = int8_output(b[out], scale[out], step, add_row(w, q, words));
    w += 4 * words;
  }
}

}  // namespace eagerx::policy
