# Every example does what it says, on Linux: ctest -L examples
include(${PROJECT_SOURCE_DIR}/examples/examples.cmake)
eagerx_find_examples(examples)
foreach(example IN LISTS examples)
  if(EAGERX_SANITIZE AND EXISTS ${PROJECT_SOURCE_DIR}/examples/${example}/programs)
    # Its emulator has a clock of its own, which the sanitizer asks before it is there (tests/ftdi).
    file(STRINGS ${PROJECT_SOURCE_DIR}/examples/${example}/programs hardware REGEX RealEngine)
    if(hardware)
      continue()
    endif()
  endif()
  eagerx_add_example(${example} WITHOUT_BOARDS)
  add_test(NAME examples.${example} COMMAND ${PROJECT_SOURCE_DIR}/examples/${example}/evaluate ${EAGERX_EXAMPLE_PROGRAMS})
  set_tests_properties(examples.${example} PROPERTIES LABELS examples ENVIRONMENT EAGERX_GEN=$<TARGET_FILE:eagerx-gen>)
endforeach()
# The swing-up on the other engine that needs no library; those that do are tested in no_alloc/ and ftdi/.
eagerx_add_graph(TARGET examples_gym_swing_up GRAPH ${PROJECT_SOURCE_DIR}/examples/pendulum_swing_up/graph.yaml
                 ENGINE GymEngine)
add_test(NAME examples.pendulum_swing_up.GymEngine
         COMMAND ${PROJECT_SOURCE_DIR}/examples/pendulum_swing_up/evaluate linux-sim=$<TARGET_FILE:examples_gym_swing_up>)
set_tests_properties(examples.pendulum_swing_up.GymEngine PROPERTIES LABELS examples)
# What is unfinished in the exercises of the tutorials is found, and their answers are accepted.
add_test(NAME examples.exercises COMMAND ${CMAKE_CURRENT_LIST_DIR}/exercises ${PROJECT_BINARY_DIR})
set_tests_properties(examples.exercises PROPERTIES LABELS examples)
