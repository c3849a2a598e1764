# A program for each recording, which compares itself with it.
set(recordings p01)
foreach(name IN LISTS recordings)
  set(folder ${CMAKE_CURRENT_LIST_DIR}/${name})
  eagerx_add_graph(TARGET conformance_${name} GRAPH ${folder}/graph.yaml BOARD conformance
                   PATHS ${CMAKE_CURRENT_LIST_DIR}/targets)
  add_test(NAME conformance.${name} COMMAND conformance_${name} ${folder}/expected.csv)
endforeach()
add_test(NAME conformance.refuses COMMAND ${CMAKE_CURRENT_LIST_DIR}/refuses $<TARGET_FILE:conformance_p01>
                                          ${CMAKE_CURRENT_LIST_DIR}/p01/expected.csv)
