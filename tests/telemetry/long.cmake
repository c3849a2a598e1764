# Compares the telemetry of emulated boards with the trace of linux-sim, for one Arm and one RISC-V core. Run others by
# hand.
add_executable(telemetry_check ${CMAKE_CURRENT_LIST_DIR}/check.cpp)
target_link_libraries(telemetry_check PRIVATE eagerx_warnings eagerx_gen_tools eagerx_telemetry)
foreach(board mps2-an386 riscv32-virt)
  add_test(NAME telemetry.${board} COMMAND ${CMAKE_CURRENT_LIST_DIR}/run ${PROJECT_BINARY_DIR}
                                           ${CMAKE_CURRENT_BINARY_DIR}/telemetry.${board} ${board})
  set_tests_properties(telemetry.${board} PROPERTIES COST 20)
endforeach()
add_test(NAME telemetry.resets COMMAND ${CMAKE_CURRENT_LIST_DIR}/run ${PROJECT_BINARY_DIR}
                                       ${CMAKE_CURRENT_BINARY_DIR}/telemetry.resets mps2-an386 resets)
set_tests_properties(telemetry.resets PROPERTIES COST 20)
# The same bytes through a serial line, and on to Foxglove.
set(sent ${CMAKE_CURRENT_BINARY_DIR}/telemetry.mps2-an386)
add_test(NAME telemetry.line COMMAND ${CMAKE_CURRENT_LIST_DIR}/../monitor/board --line $<$<BOOL:${EAGERX_LIBWEBSOCKETS}>:--forward> $<TARGET_FILE:eagerx-gen> ${sent}/sends.yaml
                                     ${sent}/generated/sends/cascade/telemetry.json ${sent}/capture ${sent}/trace COMMAND_EXPAND_LISTS)
set_tests_properties(telemetry.mps2-an386 PROPERTIES FIXTURES_SETUP telemetry)
set_tests_properties(telemetry.line PROPERTIES FIXTURES_REQUIRED telemetry SKIP_RETURN_CODE 77)
