# `build` and `run` hold the budget of what they build.
add_test(NAME budget COMMAND ${CMAKE_CURRENT_LIST_DIR}/run ${PROJECT_BINARY_DIR})
