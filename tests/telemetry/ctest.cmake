# What emulated boards send, against the trace of linux-sim; one core of Arm and one of RISC-V. Others: run by hand.
add_executable(telemetry_check ${CMAKE_CURRENT_LIST_DIR}/check.cpp)
target_link_libraries(telemetry_check PRIVATE eagerx_warnings eagerx_gen_telemetry eagerx_telemetry eagerx_gen_base)
foreach(board mps2-an386 riscv32-virt)
  add_test(NAME telemetry.${board} COMMAND ${CMAKE_CURRENT_LIST_DIR}/run ${PROJECT_BINARY_DIR}
                                           ${CMAKE_CURRENT_BINARY_DIR}/telemetry.${board} ${board})
  set_tests_properties(telemetry.${board} PROPERTIES COST 20)
endforeach()
add_test(NAME telemetry.resets COMMAND ${CMAKE_CURRENT_LIST_DIR}/run ${PROJECT_BINARY_DIR}
                                       ${CMAKE_CURRENT_BINARY_DIR}/telemetry.resets mps2-an386 resets)
set_tests_properties(telemetry.resets PROPERTIES COST 20)
