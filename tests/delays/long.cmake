# A delay of a sensor, said in three ways.
set(programs)
foreach(graph of_object of_sensor of_connection without)
  eagerx_add_graph(TARGET delay_${graph} GRAPH ${CMAKE_CURRENT_LIST_DIR}/${graph}.yaml)
  list(APPEND programs $<TARGET_FILE:delay_${graph}>)
endforeach()
add_test(NAME delays COMMAND ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:eagerx-gen> ${programs})
