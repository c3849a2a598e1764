# Cortex-M7 with its double-precision floating-point unit.
set(CMAKE_SYSTEM_PROCESSOR cortex-m7)
set(EAGERX_CPU_FLAGS "-mcpu=cortex-m7 -mthumb -mfpu=fpv5-d16 -mfloat-abi=hard")
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
