# Where processes of EAGERx end up is seen in the resolved graph.
target_link_libraries(test_import PRIVATE eagerx_gen_graph)
