# Generated programs against a second implementation of the semantics: a few random graphs.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
add_test(NAME semantics.random COMMAND Python3::Interpreter ${CMAKE_CURRENT_LIST_DIR}/run --jobs 1 --seeds 0-2 --only-random $<TARGET_FILE:eagerx-gen>)
set_tests_properties(semantics.random PROPERTIES COST 10) # compiles each graph as two programs
