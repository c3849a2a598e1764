target_link_libraries(test_${name} PRIVATE eagerx_gen_network_graph)
