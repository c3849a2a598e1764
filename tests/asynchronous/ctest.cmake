# A graph with `sync: false` on an engine that is nothing but a clock, which the test moves.
eagerx_add_graph(TARGET asynchronous GRAPH ${CMAKE_CURRENT_LIST_DIR}/graph.yaml)
get_target_property(sources asynchronous EAGERX_SOURCES)
add_executable(asynchronous_test ${CMAKE_CURRENT_LIST_DIR}/asynchronous_test.cpp)
add_dependencies(asynchronous_test asynchronous)
target_include_directories(asynchronous_test PRIVATE ${sources} ${CMAKE_CURRENT_LIST_DIR})
target_link_libraries(asynchronous_test PRIVATE eagerx_warnings eagerx::runtime GTest::gtest_main)
gtest_discover_tests(asynchronous_test TEST_PREFIX asynchronous. DISCOVERY_TIMEOUT 60)
