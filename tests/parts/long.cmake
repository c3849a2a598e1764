# A hub and its parts do what one program does, or end with the name of the part that does not. All cuts:
# tests/parts/run BUILD WORK --list all.
add_test(NAME parts COMMAND ${CMAKE_CURRENT_LIST_DIR}/run ${PROJECT_BINARY_DIR} ${CMAKE_CURRENT_BINARY_DIR}/parts)
set_tests_properties(parts PROPERTIES COST 900) # compiles some thirty programs
# Random graphs of integer entities in random parts, all in one process; and graphs with reset nodes.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
add_test(NAME parts.random COMMAND Python3::Interpreter ${CMAKE_CURRENT_LIST_DIR}/random_parts --seeds 0-7 $<TARGET_FILE:eagerx-gen>)
add_test(NAME parts.random_resets COMMAND Python3::Interpreter ${CMAKE_CURRENT_LIST_DIR}/random_parts --reset-nodes --seeds 0-3 $<TARGET_FILE:eagerx-gen>)
set_tests_properties(parts.random parts.random_resets PROPERTIES COST 50) # compiles the hubs and parts of twelve graphs
# In real time, as the line to a part has the machine's clock.
add_test(NAME parts.hardware COMMAND ${CMAKE_CURRENT_LIST_DIR}/hardware ${PROJECT_BINARY_DIR})
set_tests_properties(parts.hardware PROPERTIES COST 400) # compiles four programs
# The same over TCP, over TCP with a key and over serial lines: a quadrotor and a quadruped. All five cuts: tests/parts/lines.
add_test(NAME parts_lines COMMAND ${CMAKE_CURRENT_LIST_DIR}/lines ${PROJECT_BINARY_DIR} ${CMAKE_CURRENT_BINARY_DIR}/parts_lines
                                  quadrotor_5 quadruped_2)
set_tests_properties(parts_lines PROPERTIES COST 400) # compiles some ten programs
# Parts that are lost and come back at the start of an episode. More of each: tests/parts/reconnect.
add_test(NAME parts_reconnect COMMAND ${CMAKE_CURRENT_LIST_DIR}/reconnect ${PROJECT_BINARY_DIR} ${CMAKE_CURRENT_BINARY_DIR}/parts_reconnect)
set_tests_properties(parts_reconnect PROPERTIES COST 300) # compiles four programs
