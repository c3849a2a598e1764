# Files of a program that was killed. 100 random moments: tests/killed/run PROGRAM 100
add_test(NAME killed COMMAND ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:replay_swing_up> 12)
