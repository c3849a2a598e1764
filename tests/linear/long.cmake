# The sampled loop of `eagerx-gen linearize` against closed forms, and against the program: where its delay margin ends.
set(programs)
foreach(name first_order cascade fine_cascade balancer fine_balancer servo quadrotor policy)
  eagerx_add_graph(TARGET linear_${name} GRAPH ${CMAKE_CURRENT_LIST_DIR}/${name}.yaml)
  list(APPEND programs ${name}=$<TARGET_FILE:linear_${name}>)
endforeach()
add_test(NAME linear COMMAND ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:eagerx-gen> ${programs})
add_test(NAME linear.drawing COMMAND ${CMAKE_CURRENT_LIST_DIR}/drawing $<TARGET_FILE:eagerx-gen> ${PROJECT_SOURCE_DIR}/targets/linearize/README.md)
