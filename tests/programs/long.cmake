# Graphs that use everything become programs that compile without a warning and run.
add_test(NAME programs COMMAND ${CMAKE_CURRENT_LIST_DIR}/run ${PROJECT_BINARY_DIR})
add_test(NAME programs.many_nodes COMMAND ${CMAKE_CURRENT_LIST_DIR}/many_nodes $<TARGET_FILE:eagerx-gen>)
