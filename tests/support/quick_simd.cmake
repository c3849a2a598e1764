# For tests that look at the messages of libraries of environments, and not at their speed: code for this machine alone, the
# same bits in a quarter of the time to compile. `export CMAKE_TOOLCHAIN_FILE=…/quick_simd.cmake` reaches what
# `eagerx-gen campaign`, `train` and Python's `make` build; this says nothing of a system, so nothing is cross-compiled.
set(EAGERX_INSTRUCTION_SETS plain)
# Besides plain ones only the widest of this processor, which a library takes for more than a few environments. Every kind is
# compared in tests/environments/vectorized, also with parameters that are tuned (blocks.yaml).
file(STRINGS /proc/cpuinfo flags REGEX "^flags" LIMIT_COUNT 1)
if("${flags} " MATCHES " avx512f .*avx512dq .*avx512bw .*avx512vl ")
  set(EAGERX_INSTRUCTION_SETS avx512)
elseif("${flags} " MATCHES " avx2 ")
  set(EAGERX_INSTRUCTION_SETS avx2)
endif()
set(EAGERX_SIMD_LEVEL -Og)
