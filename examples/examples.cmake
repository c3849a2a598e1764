# eagerx_add_example(<example> [ENGINE <name>] [ONLY <program>...] [WITHOUT_BOARDS])
#
# The programs of an example, as targets <example>.<program>, and the list of them as <build>/<example>.programs:
# a line NAME=FILE for each, which is what the example's `evaluate` takes. A line of the example's file `programs`
# is
#   NAME GRAPH [--engine ENGINE] [--policy FILE] [--target TARGET]
#   NAME CMakeLists.txt --program PROGRAM [--target TARGET]
# where the second is the PROGRAM of the example's own project; and an example without that file has one program: linux-sim, of graph.yaml, on the target of that name. ENGINE
# is the engine of all programs that do not name one; WITHOUT_BOARDS leaves out programs with a --target. Programs on
# RealEngine run on emulated hardware.
# EAGERX_EXAMPLE_PROGRAMS is the list, too.
include_guard(GLOBAL)
set(EAGERX_EXAMPLES_DIR ${CMAKE_CURRENT_LIST_DIR})

# All examples: folders with an `evaluate`.
function(eagerx_find_examples variable)
  file(GLOB files RELATIVE ${EAGERX_EXAMPLES_DIR} CONFIGURE_DEPENDS ${EAGERX_EXAMPLES_DIR}/*/evaluate)
  list(TRANSFORM files REPLACE "/evaluate$" "")
  set(${variable} ${files} PARENT_SCOPE)
endfunction()

function(eagerx_add_example example)
  cmake_parse_arguments(PARSE_ARGV 1 arg "WITHOUT_BOARDS" "ENGINE" "ONLY")
  set(folder ${EAGERX_EXAMPLES_DIR}/${example})
  set(lines "linux-sim graph.yaml")
  if(EXISTS ${folder}/programs)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${folder}/programs)
    file(STRINGS ${folder}/programs lines REGEX "^[^#]")
  endif()
  add_custom_target(${example})
  set(list "")
  set(names "")
  foreach(line IN LISTS lines)
    separate_arguments(words UNIX_COMMAND "${line}")
    list(POP_FRONT words name graph)
    cmake_parse_arguments(own "" "--engine;--policy;--target;--program" "" ${words})
    if(NOT graph OR own_UNPARSED_ARGUMENTS OR own_KEYWORDS_MISSING_VALUES)
      message(FATAL_ERROR "${folder}/programs: `${line}` is not NAME GRAPH [--engine ENGINE] [--policy FILE] [--target TARGET]")
    endif()
    if((arg_ONLY AND NOT name IN_LIST arg_ONLY) OR (arg_WITHOUT_BOARDS AND own_--target))
      continue()
    endif()
    set(options)
    if(own_--engine)
      set(options ENGINE ${own_--engine})
    elseif(arg_ENGINE)
      set(options ENGINE ${arg_ENGINE})
    endif()
    if(own_--policy)
      list(APPEND options POLICY ${folder}/${own_--policy})
    endif()
    if(own_--target)
      list(APPEND options BOARD ${own_--target})
    endif()
    set(target ${example}.${name})
    if(own_--program)
      _eagerx_add_project(image ${target} ${folder} ${own_--program} "${own_--target}")
      add_dependencies(${example} ${target})
      string(APPEND list "${name}=${image}\n")
      list(APPEND names ${name}=${image})
      continue()
    endif()
    eagerx_add_graph(TARGET ${target} GRAPH ${folder}/${graph} ${options})
    add_dependencies(${example} ${target})
    get_target_property(image ${target} EAGERX_IMAGE)
    if("RealEngine" IN_LIST options)
      _eagerx_emulate(image ${target} ${image})
    endif()
    string(APPEND list "${name}=${image}\n")
    list(APPEND names ${name}=${image})
  endforeach()
  if(NOT names)
    message(FATAL_ERROR "${example} has no program `${arg_ONLY}`")
  endif()
  file(GENERATE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${example}.programs CONTENT "${list}")
  set(EAGERX_EXAMPLE_PROGRAMS ${names} PARENT_SCOPE)
endfunction()

# An example with a CMakeLists.txt of its own is built as its reader would do it.
function(_eagerx_add_project image_variable target folder program board)
  set(build ${CMAKE_CURRENT_BINARY_DIR}/${target}.build)
  set(options)
  set(image ${build}/${program})
  if(board)
    _eagerx_find_board(board_folder toolchain ${board} "")
    set(options --toolchain ${toolchain} -DBOARD=${board})
    set(image ${image}.elf)
  endif()
  add_custom_target(
    ${target} ALL
    COMMAND ${CMAKE_COMMAND} -S ${folder} -B ${build} -G ${CMAKE_GENERATOR} -DCMAKE_BUILD_TYPE=${CMAKE_BUILD_TYPE}
            -DCMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER} -Deagerx_gen_DIR=${EAGERX_PACKAGE_DIR} ${options}
    COMMAND ${CMAKE_COMMAND} --build ${build}
    DEPENDS eagerx::eagerx-gen
    BYPRODUCTS ${image}
    COMMENT "Building ${target}"
    VERBATIM)
  set(${image_variable} ${image} PARENT_SCOPE)
endfunction()

# A script that runs a program for real hardware on the emulated one.
function(_eagerx_emulate script_variable target image)
  include(${EAGERX_TARGETS_DIR}/emulated-ftdi/emulated-ftdi.cmake)
  add_dependencies(${target} emulated_ftdi)
  set(script ${CMAKE_CURRENT_BINARY_DIR}/${target}.emulated)
  file(
    GENERATE OUTPUT ${script}
    CONTENT "#!/bin/sh\nLD_PRELOAD=$<TARGET_FILE:emulated_ftdi> exec ${image} \"$@\"\n"
    FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
  set(${script_variable} ${script} PARENT_SCOPE)
endfunction()
