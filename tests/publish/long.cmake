# What programs let others see by Foxglove's protocol and by DDS.
set(guarded)
if(TARGET no_alloc_swing_up)
  set(guarded $<TARGET_FILE:no_alloc_swing_up>)
endif()
# With libwebsockets, and in a program that was built without it.
eagerx_add_graph(TARGET publish_without_websockets GRAPH ${PROJECT_SOURCE_DIR}/examples/pendulum_swing_up/graph.yaml)
# Replaces the library's one object, which then has nothing that is missing.
target_sources(publish_without_websockets PRIVATE ${PROJECT_SOURCE_DIR}/runtime/host/web_socket/no_web_socket.cpp
                                                  ${PROJECT_SOURCE_DIR}/runtime/host/web_socket/listener.cpp)
add_test(NAME publish.foxglove COMMAND Python3::Interpreter ${CMAKE_CURRENT_LIST_DIR}/foxglove $<TARGET_FILE:replay_swing_up>
                                       $<TARGET_FILE:publish_without_websockets> ${guarded})
# The same as topics of ROS 2, and an agent in another process. With another maker's DDS: tests/publish/fastdds/run.
eagerx_add_graph(TARGET publish_robot GRAPH ${CMAKE_CURRENT_LIST_DIR}/dds/robot.yaml)
add_test(NAME publish.dds COMMAND Python3::Interpreter ${CMAKE_CURRENT_LIST_DIR}/dds/check $<TARGET_FILE:replay_swing_up>
                                  $<TARGET_FILE:publish_robot> $<TARGET_FILE:eagerx-gen>)
set_tests_properties(publish.dds PROPERTIES SKIP_RETURN_CODE 77)
