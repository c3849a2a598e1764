# Cortex-M4F, 4 MB of flash at 0, 4 MB of RAM at 0x20000000.
include(${EAGERX_TARGETS_DIR}/common/cortex-m/cortex-m.cmake)

function(eagerx_configure_target executable)
  eagerx_configure_cortex_m(
    ${executable}
    FLASH 0x00000000 4M
    RAM 0x20000000 4M
    SOURCES ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/uart.cpp)
  eagerx_use_own_double_addition(${executable})
endfunction()
