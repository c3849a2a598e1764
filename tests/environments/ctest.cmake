# Many environments of a graph in one library: a program in C99, the scalar programs of the same graphs, Python.
if(EAGERX_SANITIZE)
  return() # the library is opened by programs without sanitizers
endif()
set(environments_programs)
foreach(graph pendulum multi_rate rigid)
  set(environments_graph ${CMAKE_CURRENT_LIST_DIR}/${graph}.yaml)
  if(graph STREQUAL multi_rate)
    set(environments_graph ${PROJECT_SOURCE_DIR}/tests/golden/multi_rate/graph.yaml)
  endif()
  eagerx_add_graph(TARGET environments_${graph} GRAPH ${environments_graph} BOARD environments)
  eagerx_add_graph(TARGET environments_${graph}_alone GRAPH ${environments_graph})
  list(APPEND environments_programs ${graph} $<TARGET_FILE:environments_${graph}>
       $<TARGET_FILE:environments_${graph}_alone>)
endforeach()
add_test(NAME environments COMMAND ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:eagerx-gen> ${environments_programs})
