# The hot loop stays as good as one written by hand: 15 s of compiling and counting.
add_test(NAME bench.instructions COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/instructions ${PROJECT_BINARY_DIR})
set_tests_properties(bench.instructions PROPERTIES SKIP_RETURN_CODE 77)
# Options and folders of a command that is not in CI.
add_test(NAME bench.peers COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/peer/check)
set_tests_properties(bench.peers PROPERTIES SKIP_RETURN_CODE 77)
