# Settings of a connection affect that connection only.
set(programs)
foreach(graph one_output in_the_graph)
  eagerx_add_graph(TARGET connections_${graph} GRAPH ${CMAKE_CURRENT_LIST_DIR}/${graph}.yaml)
  list(APPEND programs $<TARGET_FILE:connections_${graph}>)
endforeach()
add_test(NAME connections COMMAND ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:eagerx-gen> ${programs})
