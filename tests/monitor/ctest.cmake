# What `eagerx-gen monitor` shows of programs that publish, of logs that grow, and of what is hostile.
eagerx_add_graph(TARGET monitor_cascade GRAPH ${PROJECT_SOURCE_DIR}/examples/cascade/graph.yaml)
add_test(NAME monitor COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/check $<TARGET_FILE:eagerx-gen>
                              $<TARGET_FILE:replay_swing_up> $<TARGET_FILE:monitor_cascade>)
# The screen, where the generator has one.
get_target_property(definitions eagerx_unit_tools COMPILE_DEFINITIONS)
if(definitions MATCHES EAGERX_NCURSES)
  add_test(NAME monitor.screen COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/screen $<TARGET_FILE:eagerx-gen>
                                       $<TARGET_FILE:replay_swing_up>)
  set_tests_properties(monitor.screen PROPERTIES SKIP_RETURN_CODE 77)
else()
  eagerx_left_out(monitor.screen "there is no ncurses (toolchains/install-packages build)")
endif()
# Foxglove's protocol, of monitor and of the live page, which a browser shows where there is one.
if(EAGERX_LIBWEBSOCKETS)
  add_test(NAME monitor.foxglove COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/foxglove $<TARGET_FILE:eagerx-gen>
                                         $<TARGET_FILE:replay_swing_up>)
  add_test(NAME report.live COMMAND ${CMAKE_CURRENT_LIST_DIR}/../browser/live ${PROJECT_BINARY_DIR}
                                    $<TARGET_FILE:replay_swing_up>)
  # A browser is a package of the long tests.
  set_tests_properties(report.live PROPERTIES SKIP_RETURN_CODE 77 COST 5 LABELS long)
else()
  eagerx_left_out(monitor.foxglove "there is no libwebsockets (toolchains/install-packages publish)")
  eagerx_left_out(report.live "there is no libwebsockets (toolchains/install-packages publish)")
endif()
