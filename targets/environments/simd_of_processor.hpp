// SIMD groups that this processor can run.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <initializer_list>
#include <string_view>
#include <targets/environments/simd_kernel.hpp>

namespace eagerx::environments {

template <class Graph>
using FillSimd = void (*)(SimdKernel<Graph>&);

/// Whether EAGERX_SIMD (`none`, `plain`, `avx2` or `avx512`) allows `name`; without it, all are.
inline bool allows_simd(std::string_view name) {
  const char* const only = std::getenv("EAGERX_SIMD");
  return only == nullptr || *only == '\0' || name == only;
}

/// The widest that `environments` fill at least half: the other lanes are calculated for nothing.
template <class Graph>
SimdKernel<Graph> simd_of_processor(std::uint32_t environments, FillSimd<Graph> plain,
                                    [[maybe_unused]] FillSimd<Graph> avx2 = nullptr,
                                    [[maybe_unused]] FillSimd<Graph> avx512 = nullptr) {
  bool has_avx2 = false, has_avx512 = false;
#if defined(__x86_64__)
  has_avx2 = avx2 != nullptr && __builtin_cpu_supports("avx2");
  has_avx512 = avx512 != nullptr && __builtin_cpu_supports("avx512f") &&
               __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
               __builtin_cpu_supports("avx512vl");
#endif
  struct Choice {
    const char* isa;
    bool runs;
    FillSimd<Graph> fill;
  };
  for (const Choice& choice : {Choice{"avx512", has_avx512, avx512}, Choice{"avx2", has_avx2, avx2},
                               Choice{"plain", true, plain}}) {
    SimdKernel<Graph> kernel;
    if (choice.runs && allows_simd(choice.isa)) choice.fill(kernel);
    kernel.isa = choice.isa;
    if (kernel.lanes != 0 && 2 * std::uint64_t{environments} >= kernel.lanes) return kernel;
  }
  return {};
}

}  // namespace eagerx::environments
