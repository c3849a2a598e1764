# Subjects of the newest commits, and whether wrong ones are found. A copy of the sources without history is left out.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
add_test(NAME commits COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/run ${PROJECT_SOURCE_DIR})
set_tests_properties(commits PROPERTIES SKIP_RETURN_CODE 77)
add_test(NAME commits.falsified COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/falsify)
