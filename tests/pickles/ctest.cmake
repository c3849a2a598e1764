# Pickles that want harm: one error each, in little time and memory.
if(EAGERX_SANITIZE)
  return() # which need more of both
endif()
add_test(NAME pickles COMMAND ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:eagerx-gen>)
