# Whether what tests leave out is seen.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
add_test(NAME skips COMMAND Python3::Interpreter ${CMAKE_CURRENT_LIST_DIR}/falsify ${CMAKE_CTEST_COMMAND})
