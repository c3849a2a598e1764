#include "targets/environments/train/kernels_of.hpp"
#include "targets/environments/train/kernels_table.hpp"

namespace eagerx::train {
extern constinit const Kernels kAvx512Kernels = KernelsOf<16>::table("avx512");
}  // namespace eagerx::train
