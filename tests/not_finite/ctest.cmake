# Rewards that are no numbers, in the program, in libraries, trainer and campaign, on an emulated board.
if(EAGERX_SANITIZE)
  return() # the library is opened by programs without sanitizers
endif()
eagerx_add_graph(TARGET not_finite GRAPH ${CMAKE_CURRENT_LIST_DIR}/not_finite.yaml)
eagerx_add_graph(TARGET not_finite_library GRAPH ${CMAKE_CURRENT_LIST_DIR}/not_finite.yaml BOARD environments)
add_test(NAME not_finite COMMAND ${CMAKE_CURRENT_LIST_DIR}/run ${PROJECT_BINARY_DIR} $<TARGET_FILE:not_finite>
                                 $<TARGET_FILE:not_finite_library> $<TARGET_FILE:campaign_delays_alone>)
