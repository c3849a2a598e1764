# The hot loop stays as good as one written by hand: 15 s of compiling and counting.
add_test(NAME bench.instructions COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/instructions ${PROJECT_BINARY_DIR})
set_tests_properties(bench.instructions PROPERTIES SKIP_RETURN_CODE 77)
