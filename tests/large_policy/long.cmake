# Large policies, whose tables are a file of bytes next to their header.
if(EAGERX_SANITIZE)
  return() # it compiles without
endif()
add_test(NAME large_policy COMMAND ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:eagerx-gen> ${PROJECT_BINARY_DIR})
