# The output of `eagerx-gen monitor` for programs that publish, for growing logs, and for hostile input.
eagerx_add_graph(TARGET monitor_cascade GRAPH ${PROJECT_SOURCE_DIR}/examples/cascade/graph.yaml)
add_test(NAME monitor COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/check $<TARGET_FILE:eagerx-gen>
                              $<TARGET_FILE:replay_swing_up> $<TARGET_FILE:monitor_cascade>)
