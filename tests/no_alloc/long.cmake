if(NOT TARGET no_alloc_rigid_pendulum)
  return() # with sanitizers
endif()
# The same program does what the example promises.
add_test(NAME examples.pendulum_swing_up.OpenDynamicsEngine
         COMMAND ${PROJECT_SOURCE_DIR}/examples/pendulum_swing_up/evaluate linux-sim=$<TARGET_FILE:no_alloc_rigid_pendulum>)
set_tests_properties(examples.pendulum_swing_up.OpenDynamicsEngine PROPERTIES LABELS examples)
