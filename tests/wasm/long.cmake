# A module of WebAssembly in Node, where Emscripten is. All graphs: tests/wasm/run by hand.
if(NOT TARGET no_alloc_swing_up)
  return() # with sanitizers
endif()
find_package(Python3 REQUIRED COMPONENTS Interpreter)
# The swing-up for this machine is built for tests/no_alloc.
add_test(NAME wasm COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/run --quick $<TARGET_FILE:no_alloc_swing_up>
                           ${PROJECT_BINARY_DIR} ${CMAKE_CURRENT_BINARY_DIR}/wasm)
set_tests_properties(wasm PROPERTIES SKIP_RETURN_CODE 77 COST 10) # Emscripten is a package of the long tests
