# eagerx_gen.make(…, real_time_factor=…): an agent in Python next to a program in real time, in simulation and on the emulated
# adapter. Ten thousands of steps with agents that fail: tests/real_time/campaign.
if(EAGERX_SANITIZE)
  return() # the emulated adapter takes the place of clocks that a sanitizer looks at; tests/fuzz has the requests
endif()
eagerx_add_graph(TARGET real_time_robot GRAPH ${CMAKE_CURRENT_LIST_DIR}/robot.yaml)
add_test(NAME real_time COMMAND ${CMAKE_CURRENT_LIST_DIR}/check $<TARGET_FILE:eagerx-gen> $<TARGET_FILE:emulated_ftdi>
                                $<TARGET_FILE:real_time_robot> $<TARGET_FILE:ftdi_swing_up>
                                $<TARGET_FILE:environments_swing> $<TARGET_FILE:environments_swing_alone>
                                $<TARGET_FILE:environments_multi_rate> $<TARGET_FILE:environments_multi_rate_alone>)
