# Pictures, films and a window of a program. The programs are those of other tests.
add_test(NAME rendering COMMAND ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:tutorial_7_rendering.film> $<TARGET_FILE:running_pendulum>)
