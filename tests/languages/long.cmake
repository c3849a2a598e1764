# Parts in other languages than C++ have the hash of the one program, and their faults have an end.
add_test(NAME languages COMMAND ${CMAKE_CURRENT_LIST_DIR}/run ${PROJECT_BINARY_DIR} ${CMAKE_CURRENT_BINARY_DIR}/languages)
set_tests_properties(languages PROPERTIES COST 300) # compiles six programs
