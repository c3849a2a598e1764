# Commands that are killed; without the number 500 times each.
if(EAGERX_SANITIZE)
  return() # the library is opened by programs without sanitizers
endif()
add_test(NAME kills COMMAND ${CMAKE_CURRENT_LIST_DIR}/run ${PROJECT_BINARY_DIR} $<TARGET_FILE:environments_swing> 3)
add_test(NAME kills.generate COMMAND ${CMAKE_CURRENT_LIST_DIR}/run ${PROJECT_BINARY_DIR} $<TARGET_FILE:environments_swing> 40 generate)
