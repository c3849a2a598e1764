# Options of programs that change a run or tell of it: --set, --csv-states, --until, --measure, --summary, --strict-spaces.
eagerx_add_graph(TARGET running_pendulum GRAPH ${CMAKE_CURRENT_LIST_DIR}/graph.yaml)
eagerx_add_graph(TARGET running_sampled GRAPH ${CMAKE_CURRENT_LIST_DIR}/sampled.yaml)
add_test(NAME running COMMAND ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:running_pendulum> $<TARGET_FILE:running_sampled>)
