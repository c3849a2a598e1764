# What the commands say to somebody who types something wrong, and what to type next.
add_test(NAME commands COMMAND ${CMAKE_CURRENT_LIST_DIR}/run ${PROJECT_BINARY_DIR})
# A full disk, closed descriptors, and characters that steer terminals.
add_test(NAME commands_full_disk COMMAND ${CMAKE_CURRENT_LIST_DIR}/full_disk ${PROJECT_BINARY_DIR})
# All or nothing under SIGKILL; 1,000 kills without the number.
add_test(NAME commands_kill COMMAND ${CMAKE_CURRENT_LIST_DIR}/kill ${PROJECT_BINARY_DIR} 60)
# No output on an input or on another output, in any command.
add_test(NAME commands_one_file COMMAND ${CMAKE_CURRENT_LIST_DIR}/one_file ${PROJECT_BINARY_DIR})
# No ccache that cannot write.
add_test(NAME commands_compiler_cache COMMAND ${CMAKE_CURRENT_LIST_DIR}/compiler_cache ${PROJECT_BINARY_DIR})
