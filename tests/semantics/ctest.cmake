# Generated programs against a second implementation of the semantics: small graphs, random ones, large ones.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
add_test(NAME semantics COMMAND Python3::Interpreter ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:eagerx-gen>)
set_tests_properties(semantics PROPERTIES PROCESSORS 2)
