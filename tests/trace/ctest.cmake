# Logs for other tools and as pictures.
add_test(NAME trace COMMAND ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:eagerx-gen> $<TARGET_FILE:replay_swing_up>)
