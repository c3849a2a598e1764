# eagerx_add_test(NAME <name> TARGET <program> [EXPECTED <file.csv>] [OPTIONS <option>...])
#
# A test for ctest: runs a program that eagerx_add_graph() makes for this machine, with these options. Its exit code must
# be 0, and with EXPECTED its table (--csv) must be that of the file, character by character: the numbers of a program
# are the same on every machine. The program is started in the folder of the CMakeLists.txt, so that `agent: {csv: FILE}`
# is found there. The CMake target <name>.update writes the table of now into the file.
include_guard(GLOBAL)

function(eagerx_add_test)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "NAME;TARGET;EXPECTED" "OPTIONS")
  if(arg_UNPARSED_ARGUMENTS OR arg_KEYWORDS_MISSING_VALUES OR NOT arg_NAME OR NOT arg_TARGET)
    message(FATAL_ERROR "eagerx_add_test: cannot use `${arg_UNPARSED_ARGUMENTS}${arg_KEYWORDS_MISSING_VALUES}`; it "
                        "takes NAME TARGET [EXPECTED] [OPTIONS...]")
  endif()
  if(NOT arg_EXPECTED)
    add_test(NAME ${arg_NAME} COMMAND ${arg_TARGET} ${arg_OPTIONS} WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
    return()
  endif()
  cmake_path(ABSOLUTE_PATH arg_EXPECTED BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
  set(command ${CMAKE_COMMAND} -D PROGRAM=$<TARGET_FILE:${arg_TARGET}> -D EXPECTED=${arg_EXPECTED}
              -D FOUND=${CMAKE_CURRENT_BINARY_DIR}/${arg_NAME}.found.csv -D NAME=${arg_NAME}
              -D FOLDER=${CMAKE_CURRENT_SOURCE_DIR})
  add_test(NAME ${arg_NAME} COMMAND ${command} -P ${EAGERX_TARGETS_DIR}/cmake/EagerxCompareTable.cmake -- ${arg_OPTIONS})
  add_custom_target(
    ${arg_NAME}.update
    COMMAND ${command} -D UPDATE=ON -P ${EAGERX_TARGETS_DIR}/cmake/EagerxCompareTable.cmake -- ${arg_OPTIONS}
    DEPENDS ${arg_TARGET}
    COMMENT "Writing ${arg_EXPECTED}"
    VERBATIM)
endfunction()
