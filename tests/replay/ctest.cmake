# Runs repeated from their logs: in simulation, and of hardware on the emulated adapter.
eagerx_add_graph(TARGET replay_swing_up GRAPH ${PROJECT_SOURCE_DIR}/examples/pendulum_swing_up/graph.yaml)
eagerx_add_graph(TARGET replay_reset_node GRAPH ${PROJECT_SOURCE_DIR}/tests/conformance/recordings/c11_resetnode.yaml)
set(hardware)
if(TARGET ftdi_swing_up)
  set(hardware $<TARGET_FILE:emulated_ftdi> $<TARGET_FILE:ftdi_swing_up>)
endif()
add_test(NAME replay COMMAND ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:eagerx-gen> $<TARGET_FILE:replay_swing_up>
                             $<TARGET_FILE:replay_reset_node> ${hardware})
