# Makes `executable` a module of WebAssembly for targets/wasm/simulation.js: without Emscripten's own JavaScript, and
# without imports but for those that end the program.
function(eagerx_configure_target executable)
  set_target_properties(${executable} PROPERTIES SUFFIX .wasm)
  # Without a build type CMake would not optimise at all.
  target_compile_options(${executable} PRIVATE -Wall -Wextra -fno-exceptions -fno-rtti $<$<CONFIG:>:-O2>
                         "SHELL:-include ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/standard.hpp")
  # The memory is what a page may take at most: 1 MB of it for the stack, the rest for the program object and a picture.
  # The stack lies first: running over its end is a trap, and overwrites nothing.
  target_link_options(
    ${executable} PRIVATE --no-entry -fno-exceptions -sSTANDALONE_WASM=1 -sTOTAL_STACK=1048576 -sINITIAL_MEMORY=67108864
    -Wl,--stack-first $<$<CONFIG:>:-O2>)
endfunction()
