include(${EAGERX_TARGETS_DIR}/common/cortex-m/cortex-m.cmake)

function(eagerx_configure_target executable)
  set(here ${CMAKE_CURRENT_FUNCTION_LIST_DIR})
  eagerx_configure_cortex_m(${executable} FOLDER ${here} SOURCES ${here}/clock.cpp ${here}/outputs_off.cpp
                            ${here}/uart.cpp)
  eagerx_use_own_double_addition(${executable})
endfunction()
