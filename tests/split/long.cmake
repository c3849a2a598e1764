# Two programs with a link do what one does. Other boards: tests/split/run by hand.
add_test(NAME split COMMAND ${CMAKE_CURRENT_LIST_DIR}/run ${PROJECT_BINARY_DIR} ${CMAKE_CURRENT_BINARY_DIR}/split)
set_tests_properties(split PROPERTIES COST 1000) # first
