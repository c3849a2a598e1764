#include "targets/environments/train/kernels.hpp"

#include <array>

#include "targets/environments/train/kernels_table.hpp"

namespace eagerx::train {
namespace {

struct Here {
  std::array<const Kernels*, 3> all{};
  std::size_t count = 0;

  Here() {
    all[count++] = &kPlainKernels;
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2")) all[count++] = &kAvx2Kernels;
    if (__builtin_cpu_supports("avx512f")) all[count++] = &kAvx512Kernels;
#endif
  }
};

}  // namespace

std::span<const Kernels* const> kernels_here() {
  static const Here here;
  return {here.all.data(), here.count};
}

const Kernels* find_kernels(std::string_view name) {
  const auto here = kernels_here();
  if (name.empty()) return here.back();
  for (const Kernels* kernels : here) {
    if (name == kernels->name) return kernels;
  }
  return nullptr;
}

}  // namespace eagerx::train
