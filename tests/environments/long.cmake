# Many environments of a graph in one library: vectorized, of other graphs, Python, processes that build the same library.
if(NOT TARGET environments_swing)
  return() # with sanitizers
endif()
set(environments_vectorized)
foreach(graph rates phases estimates classics policies)
  eagerx_add_graph(TARGET environments_${graph} GRAPH ${CMAKE_CURRENT_LIST_DIR}/${graph}.yaml BOARD environments)
  list(APPEND environments_vectorized $<TARGET_FILE:environments_${graph}>)
endforeach()
eagerx_add_graph(TARGET environments_robots GRAPH ${PROJECT_SOURCE_DIR}/tests/firmware/graphs/robots.yaml BOARD environments)
list(APPEND environments_vectorized $<TARGET_FILE:environments_robots>)
add_test(NAME environments.more_vectorized COMMAND ${CMAKE_CURRENT_LIST_DIR}/vectorized ${environments_vectorized})
# Debian's Python, which has the numpy that toolchains/install-packages installs.
add_test(NAME environments.python COMMAND ${CMAKE_CURRENT_LIST_DIR}/python $<TARGET_FILE:eagerx-gen> $<TARGET_FILE:environments_swing>
                                          $<TARGET_FILE:environments_swing_alone>)
# Processes that build the same library, and are killed.
add_test(NAME environments.cache COMMAND ${CMAKE_CURRENT_LIST_DIR}/cache $<TARGET_FILE:environments_swing>)
