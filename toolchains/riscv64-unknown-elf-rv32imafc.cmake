# 32-bit RISC-V with a single-precision floating-point unit.
set(CMAKE_SYSTEM_PROCESSOR rv32imafc)
set(EAGERX_CPU_FLAGS "-march=rv32imafc -mabi=ilp32f -mcmodel=medany")
include(${CMAKE_CURRENT_LIST_DIR}/riscv64-unknown-elf.cmake)
