# Makes `executable` a program for the machine that builds it.
include(${CMAKE_CURRENT_LIST_DIR}/libraries.cmake)

function(eagerx_configure_target executable)
  eagerx_linux_sim_libraries()
  target_link_libraries(${executable} PRIVATE eagerx_pictures eagerx_linux_sim)
  # Without a build type CMake would not optimise at all.
  target_compile_options(${executable} PRIVATE -Wall -Wextra $<$<CONFIG:>:-O2>)
  target_compile_definitions(${executable} PRIVATE $<$<CONFIG:Debug>:EAGERX_CHECKS>)
  # `eagerx-gen run --sanitize`: the code of the graph's entities, and what is generated.
  if(EAGERX_SANITIZED)
    # Bounds alone leave out arrays of one element.
    set(sanitizers -fsanitize=address,undefined$<$<CXX_COMPILER_ID:GNU>:,bounds-strict>)
    target_compile_definitions(${executable} PRIVATE EAGERX_CHECKS)
    target_compile_options(${executable} PRIVATE ${sanitizers} -fno-sanitize-recover=all -fno-omit-frame-pointer -O1 -g)
    target_link_options(${executable} PRIVATE ${sanitizers})
  endif()
endfunction()
