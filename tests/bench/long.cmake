# What a call of the C interface costs one environment: half a minute of compiling and counting.
add_test(NAME bench.one_environment COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/environments/one ${PROJECT_BINARY_DIR})
set_tests_properties(bench.one_environment PROPERTIES SKIP_RETURN_CODE 77)
