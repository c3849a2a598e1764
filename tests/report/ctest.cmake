# Pages of graphs: eagerx-gen report.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
add_test(NAME report COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/run ${PROJECT_BINARY_DIR})
add_test(NAME report.training COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/training ${PROJECT_BINARY_DIR})
