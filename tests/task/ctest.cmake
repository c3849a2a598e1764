# Results of tasks, in handwritten main loops.
set(task_graphs tutorial many_rates gym)
add_executable(task_test ${CMAKE_CURRENT_LIST_DIR}/task_test.cpp)
foreach(graph IN LISTS task_graphs)
  eagerx_add_graph(TARGET task_${graph} GRAPH ${CMAKE_CURRENT_LIST_DIR}/${graph}.yaml LIBRARY)
  target_link_libraries(task_test PRIVATE task_${graph})
endforeach()
target_link_libraries(task_test PRIVATE eagerx_warnings GTest::gtest_main)
gtest_discover_tests(task_test TEST_PREFIX task. DISCOVERY_TIMEOUT 60)
