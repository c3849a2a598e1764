# Main loops that are not ours, on generated libraries.
set(own_loop_graphs wide converted taken_over servo arm poisoned skipped)
add_executable(own_loop ${CMAKE_CURRENT_LIST_DIR}/own_loop_test.cpp ${CMAKE_CURRENT_LIST_DIR}/controller_test.cpp
                        ${CMAKE_CURRENT_LIST_DIR}/motor_test.cpp)
foreach(graph IN LISTS own_loop_graphs)
  eagerx_add_graph(TARGET own_loop_${graph} GRAPH ${CMAKE_CURRENT_LIST_DIR}/${graph}.yaml LIBRARY)
  target_link_libraries(own_loop PRIVATE own_loop_${graph})
endforeach()
eagerx_add_graph(TARGET own_loop_motor GRAPH ${PROJECT_SOURCE_DIR}/examples/controller_in_your_main/graph.yaml VARIANT loop
                 LIBRARY OF control)
target_link_libraries(own_loop PRIVATE own_loop_motor eagerx_warnings GTest::gtest_main)
gtest_discover_tests(own_loop TEST_PREFIX own_loop. DISCOVERY_TIMEOUT 60)

# Variants that are not to be in one program.
eagerx_add_graph(TARGET own_loop_named GRAPH ${CMAKE_CURRENT_LIST_DIR}/named.yaml LIBRARY)
eagerx_add_graph(TARGET own_loop_named_fast GRAPH ${CMAKE_CURRENT_LIST_DIR}/named.yaml LIBRARY VARIANT fast)
eagerx_add_graph(TARGET own_loop_named_own GRAPH ${CMAKE_CURRENT_LIST_DIR}/named.yaml LIBRARY VARIANT own)
add_dependencies(own_loop own_loop_named own_loop_named_fast own_loop_named_own)
add_test(NAME own_loop.one_name COMMAND ${CMAKE_CURRENT_LIST_DIR}/one_name ${CMAKE_CXX_COMPILER} ${CMAKE_CURRENT_BINARY_DIR})
