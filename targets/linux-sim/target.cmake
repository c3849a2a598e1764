# Makes `executable` a program for the machine that builds it.
include(${CMAKE_CURRENT_LIST_DIR}/libraries.cmake)

function(eagerx_configure_target executable)
  eagerx_linux_sim_libraries()
  target_link_libraries(${executable} PRIVATE eagerx_pictures eagerx_linux_sim)
  # Without a build type CMake would not optimise at all.
  target_compile_options(${executable} PRIVATE -Wall -Wextra $<$<CONFIG:>:-O2>)
endfunction()
