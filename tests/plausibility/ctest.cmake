# Warnings of graphs that are allowed and hardly meant.
add_test(NAME plausibility COMMAND ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:eagerx-gen>)
