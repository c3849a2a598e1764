# Makes `library` a shared library for the machine that builds it. Only eagerx_* can be seen in it, so that one process
# can load the libraries of several graphs.
set(EAGERX_TARGET_MAKES SHARED_LIBRARY)

function(eagerx_configure_target library)
  set(here ${CMAKE_CURRENT_FUNCTION_LIST_DIR})
  if(NOT TARGET eagerx_environments)
    find_package(Threads REQUIRED)
    # Files of traces are written as by ${EAGERX_TARGETS_DIR}/linux-sim/: without its signals, interrupted() is false.
    set(sim ${here}/../linux-sim)
    add_library(eagerx_environments STATIC EXCLUDE_FROM_ALL ${here}/json.cpp ${here}/team.cpp ${sim}/text_file.cpp
                                                            ${sim}/files.cpp ${sim}/interrupt.cpp)
    set_target_properties(eagerx_environments PROPERTIES POSITION_INDEPENDENT_CODE ON)
    target_link_libraries(eagerx_environments PUBLIC eagerx::runtime Threads::Threads)
    # GCC 12's -Wrestrict is wrong about its own std::string (GCC bug 105329).
    target_compile_options(eagerx_environments PRIVATE -Wall -Wextra $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> $<$<CONFIG:>:-O2>)
  endif()
  target_link_libraries(${library} PRIVATE eagerx_environments)
  # Nobody puts another function in place of one of these.
  target_compile_options(${library} PRIVATE -fvisibility-inlines-hidden $<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>)
  # Without a build type CMake would not optimise at all.
  target_compile_options(${library} PRIVATE -Wall -Wextra $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> $<$<CONFIG:>:-O2>)
  set(visible ${CMAKE_CURRENT_BINARY_DIR}/eagerx_environments.map)
  set(functions version describe error create destroy reset step set_states get_states trace hash counts)
  list(TRANSFORM functions PREPEND "eagerx_")
  file(CONFIGURE OUTPUT ${visible} CONTENT "{ global: @functions@; local: *; };\n" @ONLY)
  target_link_options(${library} PRIVATE -Wl,--version-script=${visible} -Wl,--no-undefined)
  set_target_properties(${library} PROPERTIES OUTPUT_NAME ${library}_environments)
endfunction()
