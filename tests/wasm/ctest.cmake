# Modules that eagerx-gen has not made, written by hand: this needs Node alone.
find_program(eagerx_node NAMES node nodejs)
if(eagerx_node)
  add_test(NAME wasm_hostile COMMAND ${eagerx_node} ${CMAKE_CURRENT_LIST_DIR}/hostile.js)
else()
  eagerx_left_out(wasm_hostile "there is no Node (toolchains/install-packages tests)")
endif()
