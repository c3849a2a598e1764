# A program with a task, on Linux and on a board.
eagerx_add_graph(TARGET task_program GRAPH ${CMAKE_CURRENT_LIST_DIR}/tutorial.yaml)
add_test(NAME task COMMAND ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:task_program> ${PROJECT_BINARY_DIR})
