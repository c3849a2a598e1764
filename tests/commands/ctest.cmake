# What the commands say to somebody who types something wrong, and what to type next.
add_test(NAME commands COMMAND ${CMAKE_CURRENT_LIST_DIR}/run ${PROJECT_BINARY_DIR})
