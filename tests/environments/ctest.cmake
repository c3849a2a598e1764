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
# Of rigid bodies, whether threads disturb each other.
eagerx_add_graph(TARGET environments_rigid_step GRAPH ${CMAKE_CURRENT_LIST_DIR}/rigid_step.yaml BOARD environments)
list(APPEND environments_programs rigid_step $<TARGET_FILE:environments_rigid_step> -)
add_test(NAME environments COMMAND ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:eagerx-gen> ${environments_programs})
# Debian's Python, which has the numpy that toolchains/install-packages installs.
add_test(NAME environments.python COMMAND ${CMAKE_CURRENT_LIST_DIR}/python $<TARGET_FILE:eagerx-gen> $<TARGET_FILE:environments_pendulum>)
