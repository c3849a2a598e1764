# What eagerx-gen says about broken graphs.
add_test(NAME diagnostics COMMAND ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:eagerx-gen>)
