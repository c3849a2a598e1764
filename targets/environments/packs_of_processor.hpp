// Which packs this processor runs.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <initializer_list>
#include <string_view>
#include <targets/environments/pack_kernel.hpp>

namespace eagerx::environments {

template <class Graph>
using FillPacks = void (*)(PackKernel<Graph>&);

/// What EAGERX_PACKS says: `none`, `plain`, `avx2` or `avx512`; everything without it.
inline bool allows_packs(std::string_view name) {
  const char* const only = std::getenv("EAGERX_PACKS");
  return only == nullptr || *only == '\0' || name == only;
}

/// The widest that `environments` fill at least half: the other lanes are calculated for nothing.
template <class Graph>
PackKernel<Graph> packs_of_processor(std::uint32_t environments, FillPacks<Graph> plain,
                                     [[maybe_unused]] FillPacks<Graph> avx2 = nullptr,
                                     [[maybe_unused]] FillPacks<Graph> avx512 = nullptr) {
  bool has_avx2 = false, has_avx512 = false;
#if defined(__x86_64__)
  has_avx2 = avx2 != nullptr && __builtin_cpu_supports("avx2");
  has_avx512 = avx512 != nullptr && __builtin_cpu_supports("avx512f") &&
               __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
               __builtin_cpu_supports("avx512vl");
#endif
  struct Choice {
    bool runs;
    FillPacks<Graph> fill;
  };
  for (const Choice& choice : {Choice{has_avx512 && allows_packs("avx512"), avx512},
                               Choice{has_avx2 && allows_packs("avx2"), avx2},
                               Choice{allows_packs("plain"), plain}}) {
    PackKernel<Graph> kernel;
    if (choice.runs) choice.fill(kernel);
    if (kernel.lanes != 0 && 2 * std::uint64_t{environments} >= kernel.lanes) return kernel;
  }
  return {};
}

}  // namespace eagerx::environments
