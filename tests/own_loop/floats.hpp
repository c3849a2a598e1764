// Tells the processor to take denormal numbers for zero, as crtfastmath.o and start-up code of
// firmware do.
#pragma once

#include <cstdint>
#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace own_loop {

inline void flush_denormals(bool flush) {
#if defined(__SSE2__)
  constexpr unsigned kBits = 0x8040U;  // flush to zero, denormals are zero
  _mm_setcsr(flush ? _mm_getcsr() | kBits : _mm_getcsr() & ~kBits);
#elif defined(__aarch64__)
  constexpr std::uint64_t kBit = std::uint64_t{1} << 24U;  // FZ
  std::uint64_t control = 0;
  asm volatile("mrs %0, fpcr" : "=r"(control));
  control = flush ? control | kBit : control & ~kBit;
  asm volatile("msr fpcr, %0" : : "r"(control));
#elif defined(__ARM_FP)
  constexpr std::uint32_t kBit = 1U << 24U;  // FZ
  std::uint32_t control = 0;
  asm volatile("vmrs %0, fpscr" : "=r"(control));
  control = flush ? control | kBit : control & ~kBit;
  asm volatile("vmsr fpscr, %0" : : "r"(control));
#else
#error "this processor cannot flush denormal numbers"
#endif
}

}  // namespace own_loop
