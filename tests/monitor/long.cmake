find_package(Python3 REQUIRED COMPONENTS Interpreter)
# The screen, where the generator has one.
get_target_property(definitions eagerx_gen_tools COMPILE_DEFINITIONS)
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
  set_tests_properties(report.live PROPERTIES SKIP_RETURN_CODE 77 COST 5)
else()
  eagerx_left_out(monitor.foxglove "there is no libwebsockets (toolchains/install-packages publish)")
  eagerx_left_out(report.live "there is no libwebsockets (toolchains/install-packages publish)")
endif()
