# Code that libraries of environments of all graphs share, built once per build tree or machine
# (runtime/host/compiled_library.cmake).
function(eagerx_environments_libraries)
  set(here ${CMAKE_CURRENT_FUNCTION_LIST_DIR})
  include(${here}/../../runtime/host/host.cmake)
  if(TARGET eagerx_environments)
    return()
  endif()
  set(names checks columns description fields painter place_of_reward problem state_rows trace_file workload)
  list(TRANSFORM names PREPEND ${here}/base/)
  list(TRANSFORM names APPEND .cpp)
  eagerx_compiled_library(
    eagerx_environments UNITY
    SOURCES ${names}
    FOLDERS ${here}/base ${here}/../common ${here}/../../runtime
    LINK eagerx_base
    # GCC 12's -Wrestrict is wrong about its own std::string (GCC bug 105329).
    OPTIONS -fPIC -Wall -Wextra $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
endfunction()
