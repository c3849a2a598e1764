# The part of environments' libraries that does not depend on a graph (runtime/host/compiled_library.cmake).
include(${CMAKE_CURRENT_LIST_DIR}/../../runtime/host/compiled_library.cmake)

function(eagerx_environments_library)
  if(TARGET eagerx_environments)
    return()
  endif()
  set(here ${CMAKE_CURRENT_FUNCTION_LIST_DIR})
  find_package(Threads REQUIRED)
  # Files of traces are written as by ${EAGERX_TARGETS_DIR}/linux-sim/: without its signals, interrupted() is false.
  set(sim ${here}/../linux-sim)
  # GCC 12's -Wrestrict is wrong about its own std::string (GCC bug 105329).
  eagerx_compiled_library(
    eagerx_environments UNITY
    SOURCES ${here}/json.cpp ${here}/team.cpp ${sim}/text_file.cpp ${sim}/files.cpp ${sim}/interrupt.cpp
    FOLDERS ${here} ${sim} ${here}/../common ${here}/../../runtime
    LINK eagerx::runtime Threads::Threads
    OPTIONS -fPIC -Wall -Wextra $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
endfunction()
