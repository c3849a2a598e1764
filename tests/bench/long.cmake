# The cost of a C interface call for one environment. Takes half a minute to compile and count.
add_test(NAME bench.one_environment COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/environments/one ${PROJECT_BINARY_DIR})
set_tests_properties(bench.one_environment PROPERTIES SKIP_RETURN_CODE 77)
