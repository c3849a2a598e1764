# Many environments of a graph in one library: a program in C99, the scalar programs of the same graphs, Python.
if(EAGERX_SANITIZE AND NOT EAGERX_SANITIZE STREQUAL thread)
  return() # the library is opened by programs without sanitizers
endif()
set(environments_programs)
foreach(graph swing multi_rate rigid pushed_box)
  set(environments_graph ${CMAKE_CURRENT_LIST_DIR}/${graph}.yaml)
  set(environments_alone $<TARGET_FILE:environments_${graph}_alone>)
  if(graph STREQUAL multi_rate)
    set(environments_graph ${PROJECT_SOURCE_DIR}/tests/golden/multi_rate/graph.yaml)
  elseif(graph STREQUAL pushed_box)
    set(environments_graph ${PROJECT_SOURCE_DIR}/tests/no_alloc/pushed_box.yaml)
    set(environments_alone $<TARGET_FILE:no_alloc_pushed_box>)
    if(EAGERX_SANITIZE)
      set(environments_alone -) # the guard against allocation takes the place that the sanitizer's malloc has
    endif()
  elseif(graph STREQUAL rigid)
    set(environments_alone -) # whether threads disturb each other
  endif()
  if(graph STREQUAL swing)
    unset(EAGERX_INSTRUCTION_SETS) # to see that those for other processors compile
    unset(EAGERX_SIMD_LEVEL) # and that the bits are those of -O3
  endif()
  eagerx_add_graph(TARGET environments_${graph} GRAPH ${environments_graph} BOARD environments)
  set(EAGERX_INSTRUCTION_SETS native)
  set(EAGERX_SIMD_LEVEL -Og)
  if(environments_alone MATCHES environments_)
    eagerx_add_graph(TARGET environments_${graph}_alone GRAPH ${environments_graph})
  endif()
  list(APPEND environments_programs ${graph} $<TARGET_FILE:environments_${graph}> ${environments_alone})
endforeach()
# Graphs that run vectorized: more in long.cmake, and `tests/environments/vectorized_of` compares those of every example.
eagerx_add_graph(TARGET environments_blocks GRAPH ${CMAKE_CURRENT_LIST_DIR}/blocks.yaml BOARD environments)
# Ctrl-C at each place where Python looks for it.
add_test(NAME environments.interrupts COMMAND ${CMAKE_CURRENT_LIST_DIR}/interrupts $<TARGET_FILE:environments_swing> $<TARGET_FILE:environments_swing_alone>)
add_test(NAME environments.vectorized COMMAND ${CMAKE_CURRENT_LIST_DIR}/vectorized $<TARGET_FILE:environments_swing> $<TARGET_FILE:environments_blocks>)
add_test(NAME environments.stages COMMAND ${CMAKE_CURRENT_LIST_DIR}/stages $<TARGET_FILE:environments_swing>)
add_test(NAME environments COMMAND ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:eagerx-gen> ${environments_programs})
# A graph without an engine, whose outputs have a guard.
eagerx_add_graph(TARGET environments_controller GRAPH ${PROJECT_SOURCE_DIR}/tests/own_loop/arm.yaml BOARD environments)
add_test(NAME environments.controller COMMAND ${CMAKE_CURRENT_LIST_DIR}/controller $<TARGET_FILE:environments_controller>)
# 3,000 wrong calls; more of them, and with the address sanitizer: tests/environments/misuse EAGERX_GEN 100000
add_test(NAME environments.misuse COMMAND ${CMAKE_CURRENT_LIST_DIR}/misuse $<TARGET_FILE:environments_swing>)
# A policy with actions from -1 to 1: the program's returns are those of a rollout in Python.
eagerx_add_graph(TARGET environments_normalized GRAPH ${CMAKE_CURRENT_LIST_DIR}/normalized.yaml BOARD environments)
eagerx_add_graph(TARGET environments_normalized_alone GRAPH ${CMAKE_CURRENT_LIST_DIR}/normalized.yaml)
add_test(NAME environments.normalized COMMAND ${CMAKE_CURRENT_LIST_DIR}/normalized $<TARGET_FILE:environments_normalized> $<TARGET_FILE:environments_normalized_alone>)
