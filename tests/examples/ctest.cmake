# A few examples do what they say, on Linux; the others in long.cmake: ctest -L examples
include(${PROJECT_SOURCE_DIR}/examples/examples.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/example.cmake)
set(eagerx_first_examples pendulum_swing_up arm_reaching cascade)
foreach(example IN LISTS eagerx_first_examples)
  eagerx_test_example(${example})
endforeach()
