# The picture drawn again, and compared; includes that are wrong are found.
add_test(NAME architecture.drawn COMMAND ${CMAKE_CURRENT_LIST_DIR}/run ${PROJECT_BINARY_DIR} --draw)
set_tests_properties(architecture.drawn PROPERTIES COST 35)
add_test(NAME architecture.falsified COMMAND ${CMAKE_CURRENT_LIST_DIR}/falsify ${PROJECT_BINARY_DIR})
