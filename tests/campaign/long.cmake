# Many runs of a graph: `campaign` looks at the whole report, on libraries that other tests have built and on one whose
# policy remembers.
if(EAGERX_SANITIZE AND NOT EAGERX_SANITIZE STREQUAL thread)
  return() # the library is opened by programs without sanitizers
endif()
eagerx_add_graph(TARGET campaign_memory GRAPH ${CMAKE_CURRENT_LIST_DIR}/memory.yaml BOARD environments)
eagerx_add_graph(TARGET campaign_memory_alone GRAPH ${CMAKE_CURRENT_LIST_DIR}/memory.yaml)
eagerx_add_graph(TARGET campaign_delays GRAPH ${CMAKE_CURRENT_LIST_DIR}/delays.yaml BOARD environments)
eagerx_add_graph(TARGET campaign_delays_alone GRAPH ${CMAKE_CURRENT_LIST_DIR}/delays.yaml)
add_test(NAME campaign COMMAND ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:eagerx-campaign>
         swing=$<TARGET_FILE:environments_swing>=$<TARGET_FILE:environments_swing_alone>
         memory=$<TARGET_FILE:campaign_memory>=$<TARGET_FILE:campaign_memory_alone>
         delays=$<TARGET_FILE:campaign_delays>=$<TARGET_FILE:campaign_delays_alone>)
if(EAGERX_MPI)
  add_test(NAME campaign.mpi COMMAND ${CMAKE_CURRENT_LIST_DIR}/mpi ${PROJECT_BINARY_DIR})
  set_tests_properties(campaign.mpi PROPERTIES PROCESSORS 2)
endif()
