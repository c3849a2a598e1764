# Images that run, fault in the right words, or must not link.
add_test(NAME firmware COMMAND ${CMAKE_CURRENT_LIST_DIR}/run ${PROJECT_BINARY_DIR} ${CMAKE_CURRENT_BINARY_DIR}/firmware)
