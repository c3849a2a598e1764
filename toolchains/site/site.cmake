# The reference, a folder of HTML: `cmake --build BUILD --target site` makes BUILD/site, and what is installed has it in
# share/doc/eagerx-gen/html. Without cmark-gfm or python3-yaml (toolchains/install-packages site) there is none.
include(GNUInstallDirs)
find_program(EAGERX_CMARK cmark-gfm)
execute_process(COMMAND /usr/bin/python3 -c "import yaml" RESULT_VARIABLE no_yaml OUTPUT_QUIET ERROR_QUIET)
if(NOT EAGERX_CMARK OR no_yaml)
  message(STATUS "without the reference: there is no cmark-gfm or python3-yaml (toolchains/install-packages site)")
  return()
endif()

set(made ${PROJECT_BINARY_DIR}/site)
set(kinds md yaml hpp cpp svg png)
foreach(top generator templates runtime targets toolchains models examples)
  list(TRANSFORM kinds PREPEND ${PROJECT_SOURCE_DIR}/${top}/*. OUTPUT_VARIABLE patterns)
  file(GLOB_RECURSE found CONFIGURE_DEPENDS ${patterns})
  list(APPEND shown ${found})
endforeach()
file(GLOB maker CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/* ${PROJECT_SOURCE_DIR}/*.md ${PROJECT_SOURCE_DIR}/tests/*.md)
set(emulator)
if(CMAKE_CROSSCOMPILING)
  set(emulator --emulator "${CMAKE_CROSSCOMPILING_EMULATOR}")
endif()
add_custom_command(
  OUTPUT ${made}/words.json
  DEPENDS eagerx-gen eagerx-gen-tools ${shown} ${maker} # the programs themselves: one starts the other
  COMMAND ${CMAKE_CURRENT_LIST_DIR}/make --generator $<TARGET_FILE:eagerx-gen> ${emulator} -o ${made}
  COMMENT "Making the reference"
  VERBATIM)
add_custom_target(site ALL DEPENDS ${made}/words.json)
install(DIRECTORY ${made}/ DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/eagerx-gen/html)
