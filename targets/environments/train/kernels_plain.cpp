// Kernels that every machine can run: SSE2 on x86-64, NEON on aarch64.
#include "targets/environments/train/kernels_of.hpp"
#include "targets/environments/train/kernels_table.hpp"

namespace eagerx::train {
extern constinit const Kernels kPlainKernels = KernelsOf<4>::table("plain");
}  // namespace eagerx::train
