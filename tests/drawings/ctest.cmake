# Drawings of graphs: eagerx-gen graph.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
add_test(NAME drawings COMMAND Python3::Interpreter ${CMAKE_CURRENT_LIST_DIR}/run ${PROJECT_BINARY_DIR})
