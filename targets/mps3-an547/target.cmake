include(${EAGERX_TARGETS_DIR}/common/cortex-m/cortex-m.cmake)

function(eagerx_configure_target executable)
  eagerx_configure_cortex_m(${executable} FOLDER ${CMAKE_CURRENT_FUNCTION_LIST_DIR} SOURCES ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/uart.cpp)
endfunction()
