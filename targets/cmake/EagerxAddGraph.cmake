# eagerx_add_graph(TARGET <name> GRAPH <file> [VARIANT <name>] [ENGINE <name>] [POLICY <file>] [BOARD <target>]
#                  [PATHS <folder>...] [SPLIT <names>=[<part>:]<target>...] [OUTPUT <folder>] [CHECK_ENTITIES])
# eagerx_add_graph(TARGET <name> GRAPH <file> LIBRARY [VARIANT <name>] [ENGINE <name>] [POLICY <file>] [BOARD <target>]
#                  [PATHS <folder>...] [OUTPUT <folder>] [CHECK_ENTITIES] [OF <name>...])
#
# Makes the program <name> out of a graph file, and makes it again when the graph, a manifest, a template or a
# weight file changes.
#   VARIANT one of the graph's `variants:`
#   ENGINE  the engine instead of the one the graph names
#   POLICY  weight file of a policy that decides instead of the graph's `agent`
#   BOARD   a folder of targets/, linux-sim without it; with `environments` <name> is a shared library. When the board
#           needs another compiler than this build has, <name> is built in a build tree of its own with the board's
#           toolchain file.
#   SPLIT   nodes, `agent` or `controller` in programs of their own, each as `eagerx-gen --split` takes it: <name> is
#           the program of the rest, for BOARD, and <name>.<part> that of each part; of one part without a name it is
#           <name>.board
#   CHECK_ENTITIES  also compile the entities as boards do, `eagerx-gen check --compile`: the build fails where one has
#           a heap, <cmath> or double arithmetic
#   PATHS   your own folders of entities and targets, searched first
#   LIBRARY <name> is no program but a library of headers for a main loop of your own, to link with: `#include
#           "<graph's name>.hpp"`, which says how to use it. BOARD is then the board that the graph's engine needs, if any
#   OF      nodes, composites or arrays that the library is made of alone, as `eagerx-gen generate --of`: `#include
#           "<graph's name>_<name>.hpp"`, with several names `<graph's name>_cut.hpp`
#   OUTPUT  where the generated sources go, <build>/<name>.eagerx without it
# For boards there is also <name>.size: `eagerx-gen size` of the image, which fails when the `budget:` of the graph is
# exceeded.
# The target property EAGERX_IMAGE is the program's file; EAGERX_SOURCES is OUTPUT.
include_guard(GLOBAL)

function(eagerx_add_graph)
  cmake_parse_arguments(PARSE_ARGV 0 arg "LIBRARY;CHECK_ENTITIES" "TARGET;GRAPH;VARIANT;ENGINE;POLICY;BOARD;OUTPUT"
                        "PATHS;OF;SPLIT")
  if(arg_UNPARSED_ARGUMENTS OR arg_KEYWORDS_MISSING_VALUES)
    message(FATAL_ERROR "eagerx_add_graph: cannot use `${arg_UNPARSED_ARGUMENTS}${arg_KEYWORDS_MISSING_VALUES}`; it "
                        "takes TARGET GRAPH [LIBRARY] [VARIANT] [ENGINE] [POLICY] [BOARD] [SPLIT...] [PATHS...] "
                        "[OUTPUT] [CHECK_ENTITIES] [OF...]")
  endif()
  if(arg_LIBRARY AND arg_SPLIT)
    message(FATAL_ERROR "eagerx_add_graph: a split graph has no library: leave out LIBRARY or SPLIT")
  endif()
  if(arg_OF AND NOT arg_LIBRARY)
    message(FATAL_ERROR "eagerx_add_graph: OF says what a LIBRARY is made of")
  endif()
  if(NOT arg_TARGET OR NOT arg_GRAPH)
    message(FATAL_ERROR "eagerx_add_graph: TARGET and GRAPH are needed")
  endif()
  if(NOT TARGET eagerx::eagerx-gen)
    message(FATAL_ERROR "eagerx_add_graph: the package eagerx_gen was built without its generator")
  endif()
  cmake_path(ABSOLUTE_PATH arg_GRAPH BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
  if(NOT EXISTS ${arg_GRAPH})
    message(FATAL_ERROR "eagerx_add_graph: there is no graph file ${arg_GRAPH}")
  endif()
  if(arg_POLICY)
    cmake_path(ABSOLUTE_PATH arg_POLICY BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
  endif()
  if(NOT arg_BOARD)
    set(arg_BOARD linux-sim)
  endif()
  if(NOT arg_OUTPUT)
    set(arg_OUTPUT ${arg_TARGET}.eagerx)
  endif()
  cmake_path(ABSOLUTE_PATH arg_OUTPUT BASE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR} NORMALIZE)
  set(paths)
  foreach(path IN LISTS arg_PATHS)
    cmake_path(ABSOLUTE_PATH path BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
    list(APPEND paths ${path})
  endforeach()

  set(selection) # what is made of the graph
  if(arg_VARIANT)
    list(APPEND selection --variant ${arg_VARIANT})
  endif()
  if(arg_ENGINE)
    list(APPEND selection --engine ${arg_ENGINE})
  endif()
  foreach(name IN LISTS arg_OF)
    list(APPEND selection --of ${name})
  endforeach()

  _eagerx_find_board(board_folder toolchain ${arg_BOARD} "${paths}")
  set(sources ${arg_OUTPUT})
  _eagerx_parts(parts "${arg_SPLIT}")
  if(parts)
    set(sources ${arg_OUTPUT}/host)
  endif()
  _eagerx_generate(stamp ${arg_TARGET} ${arg_GRAPH} ${arg_OUTPUT} ${sources} ${arg_BOARD} "${selection}"
                   "${arg_POLICY}" "${arg_SPLIT}" "${parts}" "${paths}" ${arg_LIBRARY})
  if(arg_LIBRARY)
    _eagerx_library(${arg_TARGET} ${stamp} ${sources} "${paths}")
    return()
  endif()
  _eagerx_build(${arg_TARGET} ${stamp} ${sources} ${arg_BOARD} ${board_folder} "${toolchain}" ${arg_GRAPH}
                "${selection}" "${paths}")
  foreach(item IN LISTS parts)
    string(REGEX MATCH "^([^:]*):(.*)$" matched ${item})
    set(part ${CMAKE_MATCH_1})
    set(board ${CMAKE_MATCH_2})
    _eagerx_find_board(board_folder toolchain ${board} "${paths}")
    _eagerx_build(${arg_TARGET}.${part} ${stamp} ${arg_OUTPUT}/${part} ${board} ${board_folder} "${toolchain}" ${arg_GRAPH}
                  "${selection}" "${paths}")
  endforeach()
endfunction()

# The parts of SPLIT as `<part>:<target>`, each once, with the names that eagerx-gen gives them.
function(_eagerx_parts parts_variable splits)
  set(parts)
  set(is_named FALSE)
  foreach(split IN LISTS splits)
    if(NOT split MATCHES "^.+=(([^=:]+):)?([^=:]+)$")
      message(FATAL_ERROR "eagerx_add_graph: SPLIT has `${split}`; it takes NAME[,NAME...]=TARGET or "
                          "NAME[,NAME...]=PART:TARGET")
    endif()
    set(target ${CMAKE_MATCH_3})
    if(CMAKE_MATCH_2)
      set(is_named TRUE)
      list(APPEND parts ${CMAKE_MATCH_2}:${target})
    else()
      list(APPEND parts ${target}:${target})
    endif()
  endforeach()
  list(REMOVE_DUPLICATES parts)
  list(LENGTH parts count)
  if(count EQUAL 1 AND NOT is_named)
    set(parts board:${target})
  endif()
  set(${parts_variable} ${parts} PARENT_SCOPE)
endfunction()

# A program from generated sources, with the compiler that the board needs.
function(_eagerx_build target stamp sources board board_folder toolchain graph selection paths)
  if(toolchain AND NOT CMAKE_CROSSCOMPILING)
    _eagerx_build_with_toolchain(${target} ${stamp} ${sources} ${board} ${board_folder} ${toolchain} ${graph} "${selection}"
                                 "${paths}")
  else()
    _eagerx_build_here(${target} ${stamp} ${sources} ${board} ${board_folder})
    foreach(path IN LISTS paths)
      cmake_path(GET path PARENT_PATH parent) # headers are included as <folder/…>
      target_include_directories(${target} PRIVATE ${parent})
    endforeach()
  endif()
  set_target_properties(${target} PROPERTIES EAGERX_SOURCES ${sources})
endfunction()

# Headers for programs of the user's own; targets that link with them wait for the generator.
function(_eagerx_library target stamp sources paths)
  add_custom_target(${target}.generate DEPENDS ${stamp})
  add_library(${target} INTERFACE)
  add_dependencies(${target} ${target}.generate)
  target_include_directories(${target} INTERFACE ${sources})
  foreach(path IN LISTS paths)
    cmake_path(GET path PARENT_PATH parent) # headers are included as <folder/…>
    target_include_directories(${target} INTERFACE ${parent})
  endforeach()
  # Which libraries the entities need is known when the graph has been read: EagerxLibraries.cmake writes these.
  target_compile_options(${target} INTERFACE @${stamp}.cflags)
  target_link_libraries(${target} INTERFACE eagerx::runtime "-Wl,@\"${stamp}.libs\"") # CMake quotes no flags of linkers
  set_target_properties(${target} PROPERTIES EAGERX_SOURCES ${sources})
endfunction()

# Folder of a board, and its toolchain file if it has one.
function(_eagerx_find_board folder_variable toolchain_variable board paths)
  set(folders ${paths})
  list(TRANSFORM folders APPEND /targets)
  unset(folder) # a caller's variable of this name would be taken for the answer
  find_path(
    folder manifest.yaml
    PATHS ${folders} ${paths} ${EAGERX_TARGETS_DIR}
    PATH_SUFFIXES ${board}
    NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH NO_CACHE)
  if(NOT folder)
    message(FATAL_ERROR "eagerx_add_graph: there is no target `${board}` in ${paths} ${EAGERX_TARGETS_DIR}")
  endif()
  set(${folder_variable} ${folder} PARENT_SCOPE)
  set(${toolchain_variable} "" PARENT_SCOPE)

  file(STRINGS ${folder}/manifest.yaml name REGEX "^toolchain:")
  if(name)
    string(REGEX REPLACE "^toolchain:[ \t\"']*([^ \t\"'#]*).*$" "\\1" name "${name}")
    set(folders ${paths})
    list(TRANSFORM folders APPEND /toolchains)
    unset(file)
    find_file(
      file ${name}
      PATHS ${folders} ${EAGERX_TOOLCHAINS_DIR}
      NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH NO_CACHE)
    if(NOT file)
      message(FATAL_ERROR "eagerx_add_graph: there is no toolchain file `${name}`, which ${folder} names")
    endif()
    set(${toolchain_variable} ${file} PARENT_SCOPE)
  endif()
endfunction()

# The file that the rule of a program writes in addition to its sources. Next to it are flags of the libraries that its
# entities need.
function(_eagerx_stamp variable target)
  set(${variable} ${CMAKE_CURRENT_BINARY_DIR}/${target}.eagerx.stamp PARENT_SCOPE)
endfunction()

# The rule that runs the generator. Sources are written only when they change; the stamp always is. So the
# stamp is the output, and whatever is compiled depends on it.
function(_eagerx_generate stamp_variable target graph output sources board selection policy splits parts paths library)
  _eagerx_stamp(stamp ${target})
  set(options --target ${board})
  set(products ${sources}/CMakeLists.txt)
  set(form)
  if(library)
    set(form --library)
  else()
    list(APPEND products ${sources}/${board}/main.cpp)
  endif()
  if(policy)
    list(APPEND form --policy ${policy})
  endif()
  list(APPEND options ${selection})
  foreach(split IN LISTS splits)
    list(APPEND options --split ${split})
  endforeach()
  foreach(path IN LISTS paths)
    list(APPEND options --path ${path})
  endforeach()
  set(libraries COMMAND ${CMAKE_COMMAND} -DFOLDER=${sources} -DSTAMP=${stamp} -P
      ${EAGERX_TARGETS_DIR}/cmake/EagerxLibraries.cmake)
  foreach(item IN LISTS parts)
    string(REGEX MATCH "^([^:]*):(.*)$" matched ${item})
    set(part ${CMAKE_MATCH_1})
    list(APPEND products ${output}/${part}/${CMAKE_MATCH_2}/main.cpp)
    _eagerx_stamp(stamp_of_part ${target}.${part})
    list(APPEND libraries COMMAND ${CMAKE_COMMAND} -DFOLDER=${output}/${part} -DSTAMP=${stamp_of_part} -P
         ${EAGERX_TARGETS_DIR}/cmake/EagerxLibraries.cmake)
  endforeach()
  set(check)
  if(arg_CHECK_ENTITIES) # of the caller
    set(check COMMAND)
    if(NOT CMAKE_CROSSCOMPILING)
      list(APPEND check ${CMAKE_COMMAND} -E env CXX=${CMAKE_CXX_COMPILER})
    endif()
    list(APPEND check $<TARGET_FILE:eagerx::eagerx-gen> check --compile ${graph} --quiet ${options})
  endif()
  add_custom_command(
    OUTPUT ${stamp}
    BYPRODUCTS ${products}
    COMMAND eagerx::eagerx-gen generate ${graph} -o ${output} --quiet ${options} ${form} --depfile ${stamp}.d
    ${check}
    ${libraries}
    COMMAND ${CMAKE_COMMAND} -E touch ${stamp}
    DEPENDS ${graph} eagerx::eagerx-gen $<TARGET_FILE:eagerx::eagerx-gen>
    DEPFILE ${stamp}.d
    COMMENT "Generating ${target} from ${graph}"
    VERBATIM)
  set(${stamp_variable} ${stamp} PARENT_SCOPE)
endfunction()

# A program, or what else the board's target.cmake says, for the compiler of this build.
function(_eagerx_build_here target stamp output board board_folder)
  set(main ${output}/${board}/main.cpp)
  set_source_files_properties(${main} PROPERTIES GENERATED TRUE OBJECT_DEPENDS ${stamp})
  unset(EAGERX_TARGET_MAKES)
  include(${board_folder}/target.cmake)
  if(EAGERX_TARGET_MAKES STREQUAL SHARED_LIBRARY)
    add_library(${target} SHARED ${main} ${stamp})
  else()
    add_executable(${target} ${main} ${stamp})
  endif()
  target_include_directories(${target} PRIVATE ${output})
  # Which libraries the entities need is known when the graph has been read: EagerxLibraries.cmake writes these.
  _eagerx_stamp(flags ${target})
  target_compile_options(${target} PRIVATE @${flags}.cflags)
  target_link_libraries(${target} PRIVATE eagerx::runtime "-Wl,@\"${flags}.libs\"") # CMake quotes no flags of linkers
  eagerx_configure_target(${target})
  set_target_properties(${target} PROPERTIES EAGERX_IMAGE $<TARGET_FILE:${target}>)
endfunction()

# A program for another compiler: the generated tree is a project of its own.
function(_eagerx_build_with_toolchain target stamp output board board_folder toolchain graph selection paths)
  set(build ${CMAKE_CURRENT_BINARY_DIR}/${target}.build)
  set(image ${build}/${target}.elf)
  set(configured ${CMAKE_CURRENT_BINARY_DIR}/${target}.eagerx.configured)
  cmake_path(GET board_folder PARENT_PATH targets_folder)
  set(kept ${EAGERX_LIBRARY_CACHE}) # what all images of a board have in common
  if(NOT kept)
    set(kept ${CMAKE_BINARY_DIR}/eagerx.libraries)
  endif()
  add_custom_command(
    OUTPUT ${configured}
    COMMAND
      ${CMAKE_COMMAND} -S ${output} -B ${build} -G ${CMAKE_GENERATOR} --toolchain ${toolchain}
      -DCMAKE_BUILD_TYPE=${CMAKE_BUILD_TYPE} -DCMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER}
      -DEAGERX_TARGET=${board} -DEAGERX_TARGETS_PATH=${targets_folder} -DEAGERX_IMAGE_NAME=${target}.elf
      -Deagerx_gen_DIR=${EAGERX_PACKAGE_DIR} -DEAGERX_LIBRARY_CACHE=${kept}
    COMMAND ${CMAKE_COMMAND} -E touch ${configured}
    DEPENDS ${stamp} ${toolchain}
    COMMENT "Configuring ${target} for ${board}"
    VERBATIM)
  # Always asks the inner build: only that knows the headers it was compiled from.
  add_custom_target(
    ${target} ALL
    COMMAND ${CMAKE_COMMAND} --build ${build}
    DEPENDS ${configured}
    BYPRODUCTS ${image}
    COMMENT "Building ${target} for ${board}"
    VERBATIM)
  set_target_properties(${target} PROPERTIES EAGERX_IMAGE ${image})
  set(options ${selection})
  foreach(path IN LISTS paths)
    list(APPEND options --path ${path})
  endforeach()
  # Measures the image, and fails if it exceeds the graph's `budget:`.
  add_custom_target(
    ${target}.size
    COMMAND eagerx::eagerx-gen size ${image} --build ${build} --graph ${graph} ${options}
    DEPENDS ${configured}
    COMMENT "Measuring ${target}"
    VERBATIM)
  add_dependencies(${target}.size ${target})
endfunction()
