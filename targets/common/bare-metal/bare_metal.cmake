# Shared by all boards without an operating system.
include_guard(DIRECTORY)
include(${CMAKE_CURRENT_LIST_DIR}/manifest.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/no_heap.cmake)

# Flags of all code for a board. -g and the .ci files of -fcallgraph-info are what `eagerx-gen size` reads; neither
# changes the image.
set(EAGERX_BARE_METAL_FLAGS
    -Wall -Wextra -Wdouble-promotion $<$<CONFIG:>:-O2> -fno-exceptions -fno-rtti -fno-threadsafe-statics
    -fno-use-cxa-atexit -fno-unwind-tables -fno-asynchronous-unwind-tables -ffunction-sections -fdata-sections
    -g -fcallgraph-info=su)

set(EAGERX_ARGUMENTS "" CACHE STRING "Options of programs that start without a debugger, such as --pace")
option(EAGERX_TRACE "Programs for boards know --trace, which takes some kB of flash" OFF)

# eagerx_board_library(<name> SOURCES <file>... [FOLDERS <folder>...] [OPTIONS <flag>...]) Code that is the same in all
# images of a board: compiled once for each core and set of flags, and cached (runtime/host/compiled_library.cmake).
function(eagerx_board_library name)
  cmake_parse_arguments(arg "" "" "SOURCES;FOLDERS;OPTIONS" ${ARGN})
  if(TARGET ${name})
    return()
  endif()
  set(targets ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../..)
  include(${targets}/../runtime/host/compiled_library.cmake)
  eagerx_compiled_library(
    ${name} OF_ITS_TYPE
    SOURCES ${arg_SOURCES}
    FOLDERS ${targets}/common ${targets}/../runtime/eagerx ${arg_FOLDERS}
    LINK eagerx::runtime
    OPTIONS ${EAGERX_BARE_METAL_FLAGS} ${arg_OPTIONS})
endfunction()

# eagerx_configure_bare_metal(<executable> FOLDER <the board's> LINKER_SCRIPT <file> STARTUP <source>
#                             SOURCES <more>... [STACK <bytes>] [LINK_OPTIONS <option>...])
# Flags, linker script and the proof that nothing uses a heap, exceptions or type information.
function(eagerx_configure_bare_metal executable)
  cmake_parse_arguments(arg "" "FOLDER;LINKER_SCRIPT;STARTUP;STACK" "SOURCES;LINK_OPTIONS" ${ARGN})
  if(NOT arg_STACK)
    set(arg_STACK 16384)
  endif()
  set(here ${CMAKE_CURRENT_FUNCTION_LIST_DIR})
  if(NOT CMAKE_CROSSCOMPILING)
    message(FATAL_ERROR "${CMAKE_CXX_COMPILER} is this machine's compiler: configure a new build folder with "
                        "--toolchain and the file that ${arg_FOLDER}/manifest.yaml names")
  endif()
  eagerx_board_memory(flash ${arg_FOLDER} flash)
  eagerx_board_memory(ram ${arg_FOLDER} ram)
  list(GET flash 0 flash_origin)
  list(GET flash 1 flash_bytes)
  list(GET ram 0 ram_origin)
  list(GET ram 1 ram_bytes)

  eagerx_board_number(clock_hz ${arg_FOLDER} clock_hz)
  set(definitions -DEAGERX_CLOCK_HZ=${clock_hz})
  _eagerx_manifest_line(baud ${arg_FOLDER} baud)
  if(baud)
    eagerx_board_number(baud ${arg_FOLDER} baud)
    list(APPEND definitions -DEAGERX_BAUD=${baud})
  endif()
  if(EAGERX_ARGUMENTS)
    list(APPEND definitions "-DEAGERX_ARGUMENTS=\"${EAGERX_ARGUMENTS}\"")
  endif()
  eagerx_board_library(
    eagerx_board
    FOLDERS ${arg_FOLDER}
    SOURCES ${arg_STARTUP} ${here}/semihosting.cpp ${here}/console.cpp ${arg_SOURCES}
    # The start-up code copies and clears memory itself.
    OPTIONS ${definitions} -fno-tree-loop-distribute-patterns)

  set_target_properties(${executable} PROPERTIES SUFFIX .elf)
  # All of it: only weak references call what the board's own sources define instead of a weak function.
  target_link_libraries(${executable} PRIVATE -Wl,--whole-archive eagerx_board -Wl,--no-whole-archive)
  target_compile_options(${executable} PRIVATE ${EAGERX_BARE_METAL_FLAGS})
  get_filename_component(board ${arg_FOLDER} NAME)
  target_compile_definitions(${executable} PRIVATE EAGERX_TRACE=$<BOOL:${EAGERX_TRACE}> EAGERX_BOARD="${board}"
                                                   $<$<BOOL:${EAGERX_ARGUMENTS}>:EAGERX_STARTS_ALONE=1>)
  target_link_options(
    ${executable}
    PRIVATE
    -nostartfiles
    -Wl,--gc-sections
    -Wl,--no-warn-rwx-segments
    -Wl,--defsym=eagerx_flash_origin=${flash_origin}
    -Wl,--defsym=eagerx_flash_bytes=${flash_bytes}
    -Wl,--defsym=eagerx_ram_origin=${ram_origin}
    -Wl,--defsym=eagerx_ram_bytes=${ram_bytes}
    -Wl,--defsym=eagerx_stack_bytes=${arg_STACK}
    -Wl,-Map=$<TARGET_FILE_DIR:${executable}>/$<TARGET_FILE_BASE_NAME:${executable}>.map
    -T
    ${arg_LINKER_SCRIPT}
    ${arg_LINK_OPTIONS})
  set_property(TARGET ${executable} APPEND PROPERTY LINK_DEPENDS ${arg_LINKER_SCRIPT})
  eagerx_forbid_heap(${executable})
  if(CMAKE_SIZE)
    add_custom_command(TARGET ${executable} POST_BUILD COMMAND ${CMAKE_SIZE} $<TARGET_FILE:${executable}> VERBATIM)
  endif()
endfunction()
