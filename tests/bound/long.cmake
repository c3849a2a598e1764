# Bounds of images against what QEMU executes, and what is said of nodes without a bound.
add_test(NAME bound COMMAND ${CMAKE_CURRENT_LIST_DIR}/run ${PROJECT_BINARY_DIR})
