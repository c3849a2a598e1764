# Generated programs against a second implementation of the semantics: small graphs, random ones, large ones.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
add_test(NAME semantics COMMAND Python3::Interpreter ${CMAKE_CURRENT_LIST_DIR}/run ${PROJECT_BINARY_DIR})
