# Files that programs may overwrite.
add_test(NAME programs_files COMMAND ${CMAKE_CURRENT_LIST_DIR}/files $<TARGET_FILE:replay_swing_up>)
