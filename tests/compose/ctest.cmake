# Arrays, composites and variants are the graphs that they stand for.
add_test(NAME compose COMMAND ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:eagerx-gen>)
