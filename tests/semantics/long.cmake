# Generated programs against a second implementation of the semantics: small graphs, large ones, more random ones.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
add_test(NAME semantics COMMAND Python3::Interpreter ${CMAKE_CURRENT_LIST_DIR}/run --jobs 1 --seeds 3-11 $<TARGET_FILE:eagerx-gen>)
set_tests_properties(semantics PROPERTIES COST 70) # compiles each graph as two programs
# Ages of data from the plan against messages that know when they were born.
add_test(NAME ages COMMAND Python3::Interpreter ${CMAKE_CURRENT_LIST_DIR}/ages $<TARGET_FILE:eagerx-gen>)
set_tests_properties(ages PROPERTIES COST 40)
