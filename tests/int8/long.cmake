# The swing-up does as well with weights of eight bits.
add_test(NAME int8 COMMAND ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:eagerx-gen> ${PROJECT_BINARY_DIR})
