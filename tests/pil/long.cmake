# Libraries that are cut out of a graph do what its nodes do: replayed, and in a loop with the plant.
add_test(NAME pil COMMAND ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:eagerx-gen>)
set(example ${PROJECT_SOURCE_DIR}/examples/controller_in_your_main)
eagerx_add_graph(TARGET pil_whole GRAPH ${example}/graph.yaml LIBRARY)
eagerx_add_graph(TARGET pil_control GRAPH ${example}/graph.yaml VARIANT loop LIBRARY OF control)
add_executable(pil_loop ${CMAKE_CURRENT_LIST_DIR}/loop_test.cpp)
target_link_libraries(pil_loop PRIVATE pil_whole pil_control eagerx_warnings GTest::gtest_main)
add_test(NAME pil.loop COMMAND pil_loop)
