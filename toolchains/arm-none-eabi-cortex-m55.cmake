# Cortex-M55 with its double-precision floating-point unit and vectors (Helium).
set(CMAKE_SYSTEM_PROCESSOR cortex-m55)
set(EAGERX_CPU_FLAGS "-mcpu=cortex-m55 -mthumb -mfloat-abi=hard")
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
