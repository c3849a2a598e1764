# Install rules and the CMake package `eagerx_gen`, which also works from the build tree
# (-Deagerx_gen_DIR=<build>) and with add_subdirectory.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(cmake_files ${CMAKE_CURRENT_LIST_DIR})
set(package_dir ${CMAKE_INSTALL_DATADIR}/cmake/eagerx_gen)
set(share_dir ${CMAKE_INSTALL_DATADIR}/eagerx-gen)

install(DIRECTORY ${PROJECT_SOURCE_DIR}/runtime/eagerx ${PROJECT_SOURCE_DIR}/runtime/host DESTINATION ${share_dir}/runtime)
install(FILES ${PROJECT_SOURCE_DIR}/runtime/flags.cmake ${PROJECT_SOURCE_DIR}/runtime/flags.txt DESTINATION ${share_dir}/runtime)
foreach(folder models targets toolchains templates examples)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder} DESTINATION ${share_dir} USE_SOURCE_PERMISSIONS
          PATTERN __pycache__ EXCLUDE PATTERN *.egg-info EXCLUDE PATTERN python/build EXCLUDE PATTERN generated EXCLUDE REGEX /toolchains/site$ EXCLUDE)
endforeach()
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${share_dir})

set(package_targets eagerx_runtime)
if(TARGET eagerx-gen)
  list(APPEND package_targets eagerx-gen)
  if(NOT TARGET eagerx::eagerx-gen)
    add_executable(eagerx::eagerx-gen ALIAS eagerx-gen)
  endif()
endif()
install(TARGETS ${package_targets} EXPORT eagerx_gen RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(EXPORT eagerx_gen NAMESPACE eagerx:: FILE eagerx_gen-targets.cmake DESTINATION ${package_dir})
export(EXPORT eagerx_gen NAMESPACE eagerx:: FILE ${PROJECT_BINARY_DIR}/eagerx_gen-targets.cmake)

# Libraries that are the same for every graph (runtime/host/compiled_library.cmake), for the compiler that builds this.
option(EAGERX_BUILD_LIBRARIES "Compile what the programs of all graphs have in common, for the package" ${PROJECT_IS_TOP_LEVEL})
set(libraries_dir ${CMAKE_INSTALL_LIBDIR}/eagerx-gen/libraries)
if(EAGERX_BUILD_LIBRARIES AND NOT CMAKE_CROSSCOMPILING)
  set(libraries ${PROJECT_BINARY_DIR}/libraries)
  include(${cmake_files}/libraries/names.cmake)
  include(${PROJECT_SOURCE_DIR}/targets/linux-sim/libraries.cmake)
  include(${PROJECT_SOURCE_DIR}/targets/environments/libraries.cmake)
  eagerx_linux_sim_libraries()
  eagerx_environments_libraries()
  # Generator and tests link them, too. Where this build compiles otherwise than programs are, they are compiled anew.
  set(compiled)
  if(CMAKE_BUILD_TYPE STREQUAL Release AND NOT CMAKE_CXX_FLAGS AND NOT EAGERX_SANITIZE AND NOT CMAKE_INTERPROCEDURAL_OPTIMIZATION)
    set(compiled ${eagerx_brought})
  endif()
  list(TRANSFORM compiled REPLACE "(.+)" "$<TARGET_FILE:\\1>" OUTPUT_VARIABLE files)
  file(GLOB_RECURSE texts CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/runtime/*.[ch]pp ${PROJECT_SOURCE_DIR}/runtime/*.cmake
       ${PROJECT_SOURCE_DIR}/targets/common/*.[ch]pp ${PROJECT_SOURCE_DIR}/targets/linux-sim/*.[ch]pp
       ${PROJECT_SOURCE_DIR}/targets/environments/*.[ch]pp ${PROJECT_SOURCE_DIR}/targets/*/libraries.cmake)
  # Tests check these texts, too, in a build type of its own: the libraries are those of every type.
  set(warnings)
  if(EAGERX_BUILD_TESTS)
    get_target_property(warnings eagerx_warnings INTERFACE_COMPILE_OPTIONS)
    list(JOIN warnings " " warnings)
  endif()
  add_custom_command(
    OUTPUT ${libraries}.stamp
    DEPENDS ${texts} ${compiled} ${cmake_files}/libraries/CMakeLists.txt ${cmake_files}/libraries/names.cmake
    COMMAND ${CMAKE_COMMAND} -E rm -rf ${libraries}
    COMMAND ${CMAKE_COMMAND} -S ${cmake_files}/libraries -B ${libraries}-build -G ${CMAKE_GENERATOR}
            -D CMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER} -D CMAKE_BUILD_TYPE=Judged "-D CMAKE_CXX_FLAGS_JUDGED=${warnings}"
            -D eagerx_gen_DIR=${PROJECT_BINARY_DIR}
            -D EAGERX_LIBRARY_CACHE=${libraries} "-D EAGERX_COMPILED=${files}"
    COMMAND ${CMAKE_COMMAND} --build ${libraries}-build --clean-first
    COMMAND ${CMAKE_COMMAND} -E touch ${libraries}.stamp
    COMMENT "Compiling what the programs of all graphs have in common"
    VERBATIM)
  add_custom_target(libraries ALL DEPENDS ${libraries}.stamp)
  if(TARGET eagerx-gen) # the package names it
    add_dependencies(libraries eagerx-gen)
  endif()
  install(DIRECTORY ${libraries}/ DESTINATION ${libraries_dir})
endif()

# The same file twice: the installed one finds its data next to itself, the build tree's in the sources.
set(EAGERX_CONFIG_SHARE_DIR "\${CMAKE_CURRENT_LIST_DIR}/../../eagerx-gen")
file(RELATIVE_PATH to_libraries /${package_dir} /${libraries_dir})
set(EAGERX_CONFIG_LIBRARIES "\${CMAKE_CURRENT_LIST_DIR}/${to_libraries}")
configure_file(${cmake_files}/eagerx_gen-config.cmake.in ${PROJECT_BINARY_DIR}/installed/eagerx_gen-config.cmake
               @ONLY)
set(EAGERX_CONFIG_SHARE_DIR ${PROJECT_SOURCE_DIR})
set(EAGERX_CONFIG_LIBRARIES ${PROJECT_BINARY_DIR}/libraries)
configure_file(${cmake_files}/eagerx_gen-config.cmake.in ${PROJECT_BINARY_DIR}/eagerx_gen-config.cmake @ONLY)

# Independent of the architecture, so that a build for a 32-bit board accepts the package of a 64-bit host.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/eagerx_gen-config-version.cmake
                                 COMPATIBILITY SameMajorVersion ARCH_INDEPENDENT)
install(FILES ${PROJECT_BINARY_DIR}/installed/eagerx_gen-config.cmake
              ${PROJECT_BINARY_DIR}/eagerx_gen-config-version.cmake DESTINATION ${package_dir})

# For projects that take this one in with add_subdirectory.
set(EAGERX_SHARE_DIR ${PROJECT_SOURCE_DIR} CACHE INTERNAL "where models, targets and toolchains are")
set(EAGERX_TARGETS_DIR ${PROJECT_SOURCE_DIR}/targets CACHE INTERNAL "folder of targets")
set(EAGERX_TOOLCHAINS_DIR ${PROJECT_SOURCE_DIR}/toolchains CACHE INTERNAL "folder of toolchain files")
set(EAGERX_PACKAGE_DIR ${PROJECT_BINARY_DIR} CACHE INTERNAL "folder of eagerx_gen-config.cmake")
include(${cmake_files}/EagerxAddGraph.cmake)
include(${cmake_files}/EagerxAddTest.cmake)
