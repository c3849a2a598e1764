# Parameters and delays from logs of a simulation and of emulated hardware.
eagerx_add_graph(TARGET identify_pendulum GRAPH ${CMAKE_CURRENT_LIST_DIR}/graph.yaml)
eagerx_add_graph(TARGET identify_truth GRAPH ${CMAKE_CURRENT_LIST_DIR}/truth.yaml)
set(hardware)
if(TARGET ftdi_swing_up)
  set(hardware $<TARGET_FILE:emulated_ftdi> $<TARGET_FILE:ftdi_swing_up>)
endif()
add_test(NAME identify COMMAND ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:eagerx-gen> $<TARGET_FILE:identify_pendulum>
                               $<TARGET_FILE:identify_truth> ${hardware})
