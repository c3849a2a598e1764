# Libraries for programs that run on Linux, see README.md. Included by the targets of such programs, which are compiled
# wherever they are wanted, and by this project for the generator: both link the same sources.
# Libraries of programs are one translation unit each, so that a program is built in seconds. tests/lint compiles every
# file by itself.
set(eagerx_host_unity ON)
if(DEFINED EAGERX_UNITY)
  set(eagerx_host_unity ${EAGERX_UNITY})
endif()
if(TARGET eagerx_trace)
  return()
endif()
add_library(eagerx_trace STATIC EXCLUDE_FROM_ALL ${CMAKE_CURRENT_LIST_DIR}/trace/channel_name.cpp
                                                 ${CMAKE_CURRENT_LIST_DIR}/trace/log_file.cpp
                                                 ${CMAKE_CURRENT_LIST_DIR}/trace/replay.cpp
                                                 ${CMAKE_CURRENT_LIST_DIR}/trace/scene_line.cpp)
target_link_libraries(eagerx_trace PUBLIC eagerx::runtime)
add_library(
  eagerx_identify STATIC EXCLUDE_FROM_ALL
  ${CMAKE_CURRENT_LIST_DIR}/identify/experiment.cpp ${CMAKE_CURRENT_LIST_DIR}/identify/identification.cpp
  ${CMAKE_CURRENT_LIST_DIR}/identify/least_squares.cpp)
target_link_libraries(eagerx_identify PUBLIC eagerx_trace)
foreach(library eagerx_trace eagerx_identify)
  set_target_properties(${library} PROPERTIES UNITY_BUILD ${eagerx_host_unity} UNITY_BUILD_BATCH_SIZE 0)
  # GCC 12's -Wrestrict is wrong about its own std::string (GCC bug 105329). Without a build type CMake would not
  # optimise at all.
  target_compile_options(${library} PRIVATE -Wall -Wextra $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> $<$<CONFIG:>:-O2>)
endforeach()
