#include "targets/environments/train/kernels_of.hpp"
#include "targets/environments/train/kernels_table.hpp"

namespace eagerx::train {
extern constinit const Kernels kAvx2Kernels = KernelsOf<8>::table("avx2");
}  // namespace eagerx::train
