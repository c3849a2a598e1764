# Cortex-M3: no floating-point unit.
set(CMAKE_SYSTEM_PROCESSOR cortex-m3)
set(EAGERX_CPU_FLAGS "-mcpu=cortex-m3 -mthumb -mfloat-abi=soft")
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
