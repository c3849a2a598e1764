// Panels on Cortex-M with a floating-point unit: eight sums, the eight sums of a group, eight
// weights and eight inputs fill its 32 registers, and every load fills eight of them.
//
// Written as assembly because compilers do not keep registers in a row. On a Cortex-M4 a product
// and a sum take one cycle each, and `vmla` takes three; a Cortex-M7 issues one `vmla` a cycle.
// `vmla` rounds the product before it adds, so both give the same bits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/policy/scalar_kernel.hpp>

// Pastes one instruction for each of eight registers in a row.
#define EAGERX_POLICY_MULTIPLY(a, b, c, d, e, f, g, h, x)    \
  "vmul.f32 " a ", " a ", " x "\n vmul.f32 " b ", " b ", " x \
  "\n"                                                       \
  "vmul.f32 " c ", " c ", " x "\n vmul.f32 " d ", " d ", " x \
  "\n"                                                       \
  "vmul.f32 " e ", " e ", " x "\n vmul.f32 " f ", " f ", " x \
  "\n"                                                       \
  "vmul.f32 " g ", " g ", " x "\n vmul.f32 " h ", " h ", " x "\n"
// The first row of a group: its products are the group's sums so far.
#define EAGERX_POLICY_FIRST_ROW(x)                                                             \
  "vldmia.32 %[w]!, {s8-s15}\n" EAGERX_POLICY_MULTIPLY("s8", "s9", "s10", "s11", "s12", "s13", \
                                                       "s14", "s15", x)
// clang-format off
#if (__ARM_FP & 8) != 0  // double precision too: Cortex-M7 and later
#define EAGERX_POLICY_ROW(x)                                              \
  "vldmia.32 %[w]!, {s16-s23}\n"                                          \
  "vmla.f32 s8, s16, " x "\n vmla.f32 s9, s17, " x "\n"                   \
  "vmla.f32 s10, s18, " x "\n vmla.f32 s11, s19, " x "\n"                 \
  "vmla.f32 s12, s20, " x "\n vmla.f32 s13, s21, " x "\n"                 \
  "vmla.f32 s14, s22, " x "\n vmla.f32 s15, s23, " x "\n"
#define EAGERX_POLICY_PRODUCTS(a, b, c, d, e, f, g, h)                                      \
  "vldmia.32 %[w]!, {s16-s23}\n vldmia.32 %[x]!, {s24-s31}\n"                               \
  "vmla.f32 " a ", s16, s24\n vmla.f32 " b ", s17, s25\n vmla.f32 " c ", s18, s26\n"        \
  "vmla.f32 " d ", s19, s27\n vmla.f32 " e ", s20, s28\n vmla.f32 " f ", s21, s29\n"        \
  "vmla.f32 " g ", s22, s30\n vmla.f32 " h ", s23, s31\n"
#else
#define EAGERX_POLICY_ROW(x)                                                                \
  "vldmia.32 %[w]!, {s16-s23}\n"                                                            \
  EAGERX_POLICY_MULTIPLY("s16", "s17", "s18", "s19", "s20", "s21", "s22", "s23", x)         \
  "vadd.f32 s8, s8, s16\n vadd.f32 s9, s9, s17\n vadd.f32 s10, s10, s18\n"                  \
  "vadd.f32 s11, s11, s19\n vadd.f32 s12, s12, s20\n vadd.f32 s13, s13, s21\n"              \
  "vadd.f32 s14, s14, s22\n vadd.f32 s15, s15, s23\n"
#define EAGERX_POLICY_PRODUCTS(a, b, c, d, e, f, g, h)                                      \
  "vldmia.32 %[w]!, {s16-s23}\n vldmia.32 %[x]!, {s24-s31}\n"                               \
  "vmul.f32 s16, s16, s24\n vmul.f32 s17, s17, s25\n vmul.f32 s18, s18, s26\n"             \
  "vmul.f32 s19, s19, s27\n vmul.f32 s20, s20, s28\n vmul.f32 s21, s21, s29\n"             \
  "vmul.f32 s22, s22, s30\n vmul.f32 s23, s23, s31\n"                                      \
  "vadd.f32 " a ", " a ", s16\n vadd.f32 " b ", " b ", s17\n vadd.f32 " c ", " c ", s18\n"  \
  "vadd.f32 " d ", " d ", s19\n vadd.f32 " e ", " e ", s20\n vadd.f32 " f ", " f ", s21\n"  \
  "vadd.f32 " g ", " g ", s22\n vadd.f32 " h ", " h ", s23\n"
#endif
#define EAGERX_POLICY_END_GROUP                                                             \
  "vadd.f32 s0, s0, s8\n vadd.f32 s1, s1, s9\n vadd.f32 s2, s2, s10\n"                      \
  "vadd.f32 s3, s3, s11\n vadd.f32 s4, s4, s12\n vadd.f32 s5, s5, s13\n"                    \
  "vadd.f32 s6, s6, s14\n vadd.f32 s7, s7, s15\n"
#define EAGERX_POLICY_REGISTERS                                                             \
  "s0", "s1", "s2", "s3", "s4", "s5", "s6", "s7", "s8", "s9", "s10", "s11", "s12", "s13",   \
  "s14", "s15", "s16", "s17", "s18", "s19", "s20", "s21", "s22", "s23", "s24", "s25",       \
  "s26", "s27", "s28", "s29", "s30", "s31"
// clang-format on

namespace eagerx::policy {

/// All panels of a layer. Not inlined, so that all layers of a program share its code.
/// w [panels][inputs][8], b and y [panels * 8], x [inputs].
[[gnu::noinline]] inline void panels_of_layer(const float* w, const float* b, const float* x,
                                              float* y, std::size_t inputs, std::size_t panels) {
  const float* const end = b + panels * kPanel;
  do {
    const float* in = x;
    std::size_t groups = inputs / kGroup;
    std::size_t rest = inputs % kGroup;
    // clang-format off
    asm volatile(
        "vldmia.32 %[b]!, {s0-s7}\n"
        "cmp %[groups], #0\n"
        "beq.w 2f\n"
        "1:\n"
        "vldmia.32 %[in]!, {s24-s31}\n"
        EAGERX_POLICY_FIRST_ROW("s24")
        EAGERX_POLICY_ROW("s25") EAGERX_POLICY_ROW("s26") EAGERX_POLICY_ROW("s27")
        EAGERX_POLICY_ROW("s28") EAGERX_POLICY_ROW("s29") EAGERX_POLICY_ROW("s30")
        EAGERX_POLICY_ROW("s31")
        EAGERX_POLICY_END_GROUP
        "subs %[groups], #1\n"
        "bne.w 1b\n"
        "2:\n"
        "cmp %[rest], #0\n"
        "beq.w 5f\n"
        "vldmia.32 %[in]!, {s24}\n"
        EAGERX_POLICY_FIRST_ROW("s24")
        "b 4f\n"
        "3:\n"
        "vldmia.32 %[in]!, {s24}\n"
        EAGERX_POLICY_ROW("s24")
        "4:\n"
        "subs %[rest], #1\n"
        "bne 3b\n"
        EAGERX_POLICY_END_GROUP
        "5:\n"
        "vstmia.32 %[y]!, {s0-s7}\n"
        : [w] "+r"(w), [b] "+r"(b), [in] "+r"(in), [y] "+r"(y), [groups] "+l"(groups),
          [rest] "+l"(rest)
        :
        : "cc", "memory", EAGERX_POLICY_REGISTERS);
    // clang-format on
  } while (b != end);
}

/// The sum of the products of `blocks` times kChains inputs and of `last`, which may be null.
[[gnu::noinline]] inline float sum_of_products(const float* w, const float* x, std::size_t blocks,
                                               const float* last) {
  register float sum asm("s0");
  // clang-format off
  asm volatile(
      "vldmia.32 %[w]!, {s0-s15}\n"
      "vldmia.32 %[x]!, {s16-s31}\n"
      "vmul.f32 s0, s0, s16\n vmul.f32 s1, s1, s17\n vmul.f32 s2, s2, s18\n"
      "vmul.f32 s3, s3, s19\n vmul.f32 s4, s4, s20\n vmul.f32 s5, s5, s21\n"
      "vmul.f32 s6, s6, s22\n vmul.f32 s7, s7, s23\n vmul.f32 s8, s8, s24\n"
      "vmul.f32 s9, s9, s25\n vmul.f32 s10, s10, s26\n vmul.f32 s11, s11, s27\n"
      "vmul.f32 s12, s12, s28\n vmul.f32 s13, s13, s29\n vmul.f32 s14, s14, s30\n"
      "vmul.f32 s15, s15, s31\n"
      "b 2f\n"
      "1:\n"
      EAGERX_POLICY_PRODUCTS("s0", "s1", "s2", "s3", "s4", "s5", "s6", "s7")
      EAGERX_POLICY_PRODUCTS("s8", "s9", "s10", "s11", "s12", "s13", "s14", "s15")
      "2:\n"
      "subs %[blocks], #1\n"
      "bne.w 1b\n"
      "cmp %[last], #0\n"
      "beq.w 3f\n"
      "vldmia.32 %[last]!, {s16-s31}\n"
      "vadd.f32 s8, s8, s24\n vadd.f32 s9, s9, s25\n vadd.f32 s10, s10, s26\n"
      "vadd.f32 s11, s11, s27\n vadd.f32 s12, s12, s28\n vadd.f32 s13, s13, s29\n"
      "vadd.f32 s14, s14, s30\n vadd.f32 s15, s15, s31\n vadd.f32 s0, s0, s16\n"
      "vadd.f32 s1, s1, s17\n vadd.f32 s2, s2, s18\n vadd.f32 s3, s3, s19\n"
      "vadd.f32 s4, s4, s20\n vadd.f32 s5, s5, s21\n vadd.f32 s6, s6, s22\n"
      "vadd.f32 s7, s7, s23\n"
      "3:\n"
      EAGERX_POLICY_END_GROUP
      "vadd.f32 s0, s0, s4\n vadd.f32 s1, s1, s5\n vadd.f32 s2, s2, s6\n"
      "vadd.f32 s3, s3, s7\n"
      "vadd.f32 s0, s0, s2\n vadd.f32 s1, s1, s3\n"
      "vadd.f32 s0, s0, s1\n"
      : [w] "+r"(w), [x] "+r"(x), [blocks] "+l"(blocks), [last] "+r"(last), "=t"(sum)
      :
      : "cc", "memory", "s1", "s2", "s3", "s4", "s5", "s6", "s7", "s8", "s9", "s10", "s11", "s12",
        "s13", "s14", "s15", "s16", "s17", "s18", "s19", "s20", "s21", "s22", "s23", "s24", "s25",
        "s26", "s27", "s28", "s29", "s30", "s31");
  // clang-format on
  return sum;
}

/// The same for `In` inputs, the last of which do not fill a block. A separate function, so that
/// its numbers do not occupy registers of the layers.
template <std::size_t In>
[[gnu::noinline]] float sum_with_rest(const float* w, const float* x) {
  float last[kChains];
  last_products<In>(w, x, last);
  return sum_of_products(w, x, In / kChains, last);
}

template <std::size_t In, std::size_t Width>
inline void tail_panel(const float* w, const float* b, const float* x, float* y) {
  if constexpr (Width > 1) {
    plain_panel<In, Width>(w, b, x, y);
  } else if constexpr (In < kChains) {
    y[0] = plain_output<In>(w, b[0], x);
  } else if constexpr (In % kChains > 0) {
    y[0] = b[0] + sum_with_rest<In>(w, x);
  } else {
    y[0] = b[0] + sum_of_products(w, x, In / kChains, nullptr);
  }
}

/// y = y < 0 ? 0 : y, eight at a time.
[[gnu::noinline]] inline void relu_eights(float* y, std::size_t eights) {
#define EAGERX_POLICY_RELU(r) \
  "vcmp.f32 " r ", #0\n vmrs APSR_nzcv, FPSCR\n it mi\n vmovmi.f32 " r ", %[zero]\n"
  // clang-format off
  asm volatile(
      "1:\n"
      "vldmia.32 %[y], {s8-s15}\n"
      EAGERX_POLICY_RELU("s8") EAGERX_POLICY_RELU("s9") EAGERX_POLICY_RELU("s10")
      EAGERX_POLICY_RELU("s11") EAGERX_POLICY_RELU("s12") EAGERX_POLICY_RELU("s13")
      EAGERX_POLICY_RELU("s14") EAGERX_POLICY_RELU("s15")
      "vstmia.32 %[y]!, {s8-s15}\n"
      "subs %[eights], #1\n"
      "bne 1b\n"
      : [y] "+r"(y), [eights] "+l"(eights)
      : [zero] "t"(0.0F)
      : "cc", "memory", "s8", "s9", "s10", "s11", "s12", "s13", "s14", "s15");
  // clang-format on
#undef EAGERX_POLICY_RELU
}

/// y = tanh(y) with eagerx::tanh's operations and bits. A third of its instructions move data; NaN
/// passes without extra code.
[[gnu::noinline]] inline void tanh_range(float* y, std::size_t count) {
  static constexpr float kConstants[7] = {detail::HyperbolicConstants<float>::kTanhIsOne,
                                          2.0F * detail::ExponentialConstants<float>::kLog2E,
                                          detail::kPowerRounder,
                                          detail::kHalfLn2,
                                          detail::kTanhNearZero[1],
                                          detail::kTanhNearZero[0],
                                          1.0F};
  std::uint32_t word = 0;
  // clang-format off
  asm volatile(
      "vldmia.32 %[constants], {s16-s22}\n"
      "1:\n"
      "vldr.32 s0, [%[y]]\n"
      "vabs.f32 s1, s0\n"
      "vcmp.f32 s1, s16\n vmrs APSR_nzcv, FPSCR\n it gt\n vmovgt.f32 s1, s16\n"
      "vmul.f32 s2, s1, s17\n vadd.f32 s2, s2, s18\n"  // n, in the low bits
      "vmov %[word], s2\n"
      "vsub.f32 s2, s2, s18\n"
      "lsls %[word], #23\n"
      "vmul.f32 s3, s2, s19\n vsub.f32 s1, s1, s3\n"   // s
      "vmov s2, %[word]\n"                             // 2^n
      "vmul.f32 s4, s1, s1\n"
      "vmul.f32 s3, s4, s20\n vadd.f32 s3, s3, s21\n"
      "vmul.f32 s4, s4, s1\n vmul.f32 s3, s4, s3\n"
      "vadd.f32 s1, s1, s3\n"                          // t
      "vsub.f32 s3, s2, s22\n vadd.f32 s2, s2, s22\n"
      "vmul.f32 s4, s2, s1\n vadd.f32 s4, s3, s4\n"
      "vmul.f32 s3, s3, s1\n vadd.f32 s2, s2, s3\n"
      "vdiv.f32 s3, s4, s2\n"
      "vmov %[word], s0\n cmp %[word], #0\n it lt\n vneglt.f32 s3, s3\n"
      "vstmia.32 %[y]!, {s3}\n"
      "subs %[count], #1\n"
      "bne 1b\n"
      : [y] "+l"(y), [count] "+l"(count), [word] "+l"(word)
      : [constants] "r"(kConstants)
      : "cc", "memory", "s0", "s1", "s2", "s3", "s4", "s16", "s17", "s18", "s19", "s20", "s21",
        "s22");
  // clang-format on
}

/// y = A(y), in a function that all layers share.
template <Activation A>
[[gnu::noinline]] void activate_range(float* y, const float* end, float slope) {
  for (; y != end; ++y) *y = activated<A>(*y, slope);
}

template <Activation A, std::size_t Out>
inline void activate_all(float* y, float slope) {
  constexpr std::size_t kEight = 8;
  if constexpr (A == Activation::identity) {
    return;
  } else if constexpr (A == Activation::relu) {
    if constexpr (Out >= kEight) relu_eights(y, Out / kEight);
    for (std::size_t k = Out - Out % kEight; k < Out; ++k) y[k] = activated<A>(y[k], slope);
  } else if constexpr (A == Activation::tanh) {
    tanh_range(y, Out);
  } else {
    activate_range<A>(y, y + Out, slope);
  }
}

template <Activation A, std::size_t In, std::size_t Panels>
inline void full_panels(const float* w, const float* b, const float* x, float* y, float slope) {
  if constexpr (Panels > 0) {
    panels_of_layer(w, b, x, y, In, Panels);
    activate_all<A, Panels * kPanel>(y, slope);
  }
}

}  // namespace eagerx::policy

#undef EAGERX_POLICY_MULTIPLY
#undef EAGERX_POLICY_FIRST_ROW
#undef EAGERX_POLICY_ROW
#undef EAGERX_POLICY_END_GROUP
#undef EAGERX_POLICY_PRODUCTS
#undef EAGERX_POLICY_REGISTERS
