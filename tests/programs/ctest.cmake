# Graphs that use everything become programs that compile without a warning and run.
add_test(NAME programs COMMAND ${CMAKE_CURRENT_LIST_DIR}/run ${PROJECT_BINARY_DIR})
# What they may overwrite.
add_test(NAME programs_files COMMAND ${CMAKE_CURRENT_LIST_DIR}/files $<TARGET_FILE:replay_swing_up>)
