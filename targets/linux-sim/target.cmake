# Makes `executable` a program for the machine that builds it. The parts that do not depend on the graph are
# one library, built once for all programs of a build tree.
function(eagerx_configure_target executable)
  if(NOT TARGET eagerx_linux_sim)
    set(here ${CMAKE_CURRENT_FUNCTION_LIST_DIR})
    add_library(
      eagerx_linux_sim STATIC EXCLUDE_FROM_ALL
      ${here}/action_file.cpp ${here}/describe.cpp ${here}/files.cpp ${here}/float_environment.cpp ${here}/identify.cpp ${here}/interrupt.cpp
      ${here}/link_port.cpp ${here}/options.cpp ${here}/nearest.cpp ${here}/expression.cpp ${here}/measures.cpp ${here}/state_settings.cpp ${here}/pacer.cpp ${here}/progress.cpp ${here}/spaces.cpp ${here}/split.cpp
      ${here}/summary.cpp ${here}/text_file.cpp
      ${here}/../common/fault.cpp)
    include(${here}/../../runtime/host/host.cmake)
    target_link_libraries(eagerx_linux_sim PUBLIC eagerx::runtime eagerx_trace eagerx_identify)
    # The headers of the standard library take most of the time: once for all files.
    set_target_properties(eagerx_linux_sim PROPERTIES UNITY_BUILD ${eagerx_host_unity} UNITY_BUILD_BATCH_SIZE 0)
    # GCC 12's -Wrestrict is wrong about its own std::string (GCC bug 105329).
    target_compile_options(eagerx_linux_sim PRIVATE -Wall -Wextra $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> $<$<CONFIG:>:-O2>)
  endif()
  # A library of its own: nothing of it is in the program of a graph that shows nothing.
  if(NOT TARGET eagerx_pictures)
    set(here ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/pictures)
    add_library(eagerx_pictures STATIC EXCLUDE_FROM_ALL ${here}/film.cpp ${here}/pictures.cpp ${here}/png.cpp ${here}/window.cpp)
    target_link_libraries(eagerx_pictures PUBLIC eagerx_linux_sim ${CMAKE_DL_LIBS})
    target_compile_options(eagerx_pictures PRIVATE -Wall -Wextra $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> $<$<CONFIG:>:-O2>)
  endif()
  target_link_libraries(${executable} PRIVATE eagerx_pictures eagerx_linux_sim)
  # Without a build type CMake would not optimise at all.
  target_compile_options(${executable} PRIVATE -Wall -Wextra $<$<CONFIG:>:-O2>)
endfunction()
