# Generated programs against a second implementation of the semantics: small graphs, random ones, large ones.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
add_test(NAME semantics COMMAND Python3::Interpreter ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:eagerx-gen>)
set_tests_properties(semantics PROPERTIES PROCESSORS 2)
# Ages of data from the plan against messages that know when they were born.
add_test(NAME ages COMMAND Python3::Interpreter ${CMAKE_CURRENT_LIST_DIR}/ages $<TARGET_FILE:eagerx-gen>)
