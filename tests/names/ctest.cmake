# Text of others stays text in every file that is written.
add_test(NAME names COMMAND ${CMAKE_CURRENT_LIST_DIR}/run ${PROJECT_BINARY_DIR})
