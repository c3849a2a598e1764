include(${EAGERX_TARGETS_DIR}/common/riscv/riscv.cmake)

function(eagerx_configure_target executable)
  eagerx_configure_riscv(${executable} FOLDER ${CMAKE_CURRENT_FUNCTION_LIST_DIR}
                         SOURCES ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/uart.cpp)
endfunction()
