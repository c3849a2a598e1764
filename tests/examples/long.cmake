# Every example does what it says, on Linux, but those of ctest.cmake: ctest -L examples
eagerx_find_examples(examples)
list(REMOVE_ITEM examples ${eagerx_first_examples})
foreach(example IN LISTS examples)
  eagerx_test_example(${example})
  if(TARGET ${example})
    list(APPEND eagerx_long_targets ${example}) # some are projects of their own
  endif()
endforeach()
# The swing-up on the other engine that needs no library; those that do are tested in no_alloc/ and ftdi/.
eagerx_add_graph(TARGET examples_gym_swing_up GRAPH ${PROJECT_SOURCE_DIR}/examples/pendulum_swing_up/graph.yaml
                 ENGINE GymEngine)
add_test(NAME examples.pendulum_swing_up.GymEngine
         COMMAND ${PROJECT_SOURCE_DIR}/examples/pendulum_swing_up/evaluate linux-sim=$<TARGET_FILE:examples_gym_swing_up>)
set_tests_properties(examples.pendulum_swing_up.GymEngine PROPERTIES LABELS examples)
# The checks of the tutorials find what is unfinished in the exercises, and accept the answers.
add_test(NAME examples.exercises COMMAND ${CMAKE_CURRENT_LIST_DIR}/exercises ${PROJECT_BINARY_DIR})
set_tests_properties(examples.exercises PROPERTIES LABELS examples)
