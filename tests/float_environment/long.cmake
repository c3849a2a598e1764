# A program that a flag of the linker tells to flush denormal numbers puts that right; a hash of one that does so during
# its run is refused.
set(float_environment_graph ${PROJECT_SOURCE_DIR}/examples/pendulum_swing_up/graph.yaml)
eagerx_add_graph(TARGET float_environment_linked GRAPH ${float_environment_graph})
target_link_options(float_environment_linked PRIVATE -ffast-math)
eagerx_add_graph(TARGET float_environment_changed GRAPH ${float_environment_graph})
target_sources(float_environment_changed PRIVATE ${CMAKE_CURRENT_LIST_DIR}/change.cpp)
add_test(NAME float_environment COMMAND ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:float_environment_linked>
                                        $<TARGET_FILE:float_environment_changed>)
