# Resets that wait for something which does not come.
eagerx_add_graph(TARGET weak_reset GRAPH ${CMAKE_CURRENT_LIST_DIR}/graph.yaml)
get_target_property(sources weak_reset EAGERX_SOURCES)
add_executable(reset_test ${CMAKE_CURRENT_LIST_DIR}/reset_test.cpp)
add_dependencies(reset_test weak_reset)
target_include_directories(reset_test PRIVATE ${sources} ${PROJECT_SOURCE_DIR})
target_link_libraries(reset_test PRIVATE eagerx_warnings eagerx::runtime GTest::gtest_main)
gtest_discover_tests(reset_test TEST_PREFIX reset. DISCOVERY_TIMEOUT 60)
