# `eagerx-gen new`, `run` and `build`: from nothing to programs on Linux and on an emulated board.
add_test(NAME starting COMMAND ${CMAKE_CURRENT_LIST_DIR}/run ${PROJECT_BINARY_DIR})
set_tests_properties(starting PROPERTIES COST 50)
# The page of the commonest tasks: every section without a training.
add_test(NAME starting.how_to COMMAND ${CMAKE_CURRENT_LIST_DIR}/follow ${PROJECT_BINARY_DIR} examples/how_to.md)
add_test(NAME starting.urdf_to_walking COMMAND ${CMAKE_CURRENT_LIST_DIR}/follow ${PROJECT_BINARY_DIR} examples/urdf_to_walking.md)
# The tutorial of control design, word for word.
add_test(NAME starting.balancing_robot COMMAND ${CMAKE_CURRENT_LIST_DIR}/follow ${PROJECT_BINARY_DIR} examples/balancing_robot/README.md)
