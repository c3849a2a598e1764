// The kernels of each instruction set.
#pragma once

#include "targets/environments/train/kernels.hpp"

namespace eagerx::train {

extern const Kernels kPlainKernels;
extern const Kernels kAvx2Kernels;    // x86-64 only
extern const Kernels kAvx512Kernels;  // x86-64 only

}  // namespace eagerx::train
