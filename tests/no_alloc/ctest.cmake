# A million steps under a guard that ends the program at any use of the heap, and proof that the guard works.
if(EAGERX_SANITIZE)
  return() # the sanitizer has its own malloc
endif()
eagerx_add_graph(TARGET no_alloc_swing_up GRAPH ${PROJECT_SOURCE_DIR}/examples/pendulum_swing_up/graph.yaml)
target_sources(no_alloc_swing_up PRIVATE ${PROJECT_SOURCE_DIR}/tests/support/no_alloc.cpp)
# A library may allocate before the first step, and not afterwards.
eagerx_add_graph(TARGET no_alloc_rigid_pendulum GRAPH ${PROJECT_SOURCE_DIR}/examples/pendulum_swing_up/graph.yaml
                 ENGINE OpenDynamicsEngine)
foreach(graph pushed_box two_link_arm)
  eagerx_add_graph(TARGET no_alloc_${graph} GRAPH ${CMAKE_CURRENT_LIST_DIR}/${graph}.yaml)
endforeach()
eagerx_add_graph(TARGET no_alloc_quadruped GRAPH ${PROJECT_SOURCE_DIR}/examples/quadruped_trot/graph.yaml)
foreach(program rigid_pendulum pushed_box two_link_arm quadruped)
  target_sources(no_alloc_${program} PRIVATE ${PROJECT_SOURCE_DIR}/tests/support/no_alloc.cpp)
endforeach()
add_executable(no_alloc_guard ${CMAKE_CURRENT_LIST_DIR}/guard.cpp ${PROJECT_SOURCE_DIR}/tests/support/no_alloc.cpp)
target_link_libraries(no_alloc_guard PRIVATE eagerx_warnings)
# The implicit method of OdeEngine alone: a whole program of it would take longer to build.
add_executable(no_alloc_stiff ${CMAKE_CURRENT_LIST_DIR}/stiff.cpp ${PROJECT_SOURCE_DIR}/tests/support/no_alloc.cpp)
target_link_libraries(no_alloc_stiff PRIVATE eagerx_warnings eagerx::runtime)
add_test(NAME no_alloc COMMAND ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:no_alloc_swing_up> $<TARGET_FILE:no_alloc_guard>
         $<TARGET_FILE:no_alloc_stiff> $<TARGET_FILE:no_alloc_rigid_pendulum> $<TARGET_FILE:no_alloc_pushed_box> $<TARGET_FILE:no_alloc_two_link_arm>
         $<TARGET_FILE:no_alloc_quadruped>)
