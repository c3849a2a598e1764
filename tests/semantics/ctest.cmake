# Generated programs against a second implementation of the semantics: small graphs, random ones, large ones.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
add_test(NAME semantics COMMAND Python3::Interpreter ${CMAKE_CURRENT_LIST_DIR}/run --jobs 1 --seeds 0-2 $<TARGET_FILE:eagerx-gen>)
add_test(NAME semantics.random COMMAND Python3::Interpreter ${CMAKE_CURRENT_LIST_DIR}/run --jobs 1 --seeds 3-11 --only-random $<TARGET_FILE:eagerx-gen>)
set_tests_properties(semantics PROPERTIES COST 50) # compiles 68 graphs as two programs
set_tests_properties(semantics.random PROPERTIES COST 20 LABELS long)
# Ages of data from the plan against messages that know when they were born.
add_test(NAME ages COMMAND Python3::Interpreter ${CMAKE_CURRENT_LIST_DIR}/ages --seeds 0-2 $<TARGET_FILE:eagerx-gen>)
add_test(NAME ages.more COMMAND Python3::Interpreter ${CMAKE_CURRENT_LIST_DIR}/ages $<TARGET_FILE:eagerx-gen>)
set_tests_properties(ages.more PROPERTIES COST 40 LABELS long)
