# eagerx_need_compiler(PROGRAM PACKAGE...): a toolchain file asks for its compiler first, so that a missing one is said
# with the Debian packages that have it.
function(eagerx_need_compiler program)
  find_program(eagerx_found_${program} ${program} NO_CMAKE_FIND_ROOT_PATH)
  mark_as_advanced(eagerx_found_${program})
  if(NOT eagerx_found_${program})
    string(REPLACE ";" " " packages "${ARGN}")
    message(FATAL_ERROR "there is no ${program}: install it with `apt install ${packages}`")
  endif()
endfunction()
