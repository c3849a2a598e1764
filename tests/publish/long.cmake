# Messages that programs publish by Foxglove's protocol and by DDS.
set(guarded)
if(TARGET no_alloc_swing_up)
  set(guarded $<TARGET_FILE:no_alloc_swing_up>)
endif()
# With libwebsockets, and in a program that was built without it, and without Cyclone DDS.
eagerx_add_graph(TARGET publish_without_libraries GRAPH ${PROJECT_SOURCE_DIR}/examples/pendulum_swing_up/graph.yaml)
# Replaces each library's one object, which then has nothing that is missing.
set(without web_socket/no_web_socket web_socket/listener dds/no_dds dds/network dds/topics)
list(TRANSFORM without PREPEND ${PROJECT_SOURCE_DIR}/runtime/host/)
list(TRANSFORM without APPEND .cpp)
target_sources(publish_without_libraries PRIVATE ${without})
add_test(NAME publish.foxglove COMMAND Python3::Interpreter ${CMAKE_CURRENT_LIST_DIR}/foxglove $<TARGET_FILE:replay_swing_up>
                                       $<TARGET_FILE:publish_without_libraries> ${guarded})
# The same as topics of ROS 2, and an agent in another process. With another maker's DDS: tests/publish/fastdds/run.
eagerx_add_graph(TARGET publish_robot GRAPH ${CMAKE_CURRENT_LIST_DIR}/dds/robot.yaml)
add_test(NAME publish.dds COMMAND Python3::Interpreter ${CMAKE_CURRENT_LIST_DIR}/dds/check $<TARGET_FILE:replay_swing_up>
                                  $<TARGET_FILE:publish_robot> $<TARGET_FILE:publish_without_libraries>
                                  $<TARGET_FILE:eagerx-gen>)
set_tests_properties(publish.dds PROPERTIES SKIP_RETURN_CODE 77)
