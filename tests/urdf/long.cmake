# Robots from URDF files, where pugixml is.
if(NOT TARGET eagerx-urdf)
  eagerx_left_out(urdf "there is no pugixml (toolchains/install-packages models)")
  return()
endif()
eagerx_add_graph(TARGET urdf_robots GRAPH ${CMAKE_CURRENT_LIST_DIR}/graph.yaml)
add_test(NAME urdf COMMAND ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:eagerx-urdf> $<TARGET_FILE:urdf_robots>)
set_tests_properties(urdf PROPERTIES WORKING_DIRECTORY ${CMAKE_CURRENT_LIST_DIR}) # where actions.csv is
