# The same bits from both compilers at every optimisation level, and from the board.
add_test(NAME determinism COMMAND ${CMAKE_CURRENT_LIST_DIR}/run ${PROJECT_BINARY_DIR} ${CMAKE_CURRENT_BINARY_DIR}/determinism)
set_tests_properties(determinism PROPERTIES COST 40)
