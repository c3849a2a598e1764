# Tests expressions to their text in C++.
target_link_libraries(test_expression PRIVATE eagerx_gen_backend)
