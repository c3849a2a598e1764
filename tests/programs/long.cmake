# Graphs that use everything become programs that compile without a warning and run.
add_test(NAME programs COMMAND ${CMAKE_CURRENT_LIST_DIR}/run ${PROJECT_BINARY_DIR})
