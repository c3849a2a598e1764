# What all Cortex-M boards have in common.
include_guard(DIRECTORY)
include(${CMAKE_CURRENT_LIST_DIR}/../no_heap.cmake)

# eagerx_configure_cortex_m(<executable> FLASH <origin> <bytes> RAM <origin> <bytes> [STACK <bytes>]
#                           SOURCES <the board's own>...)
# Start-up code, linker script, flags and the proof that nothing uses a heap or exceptions.
function(eagerx_configure_cortex_m executable)
  cmake_parse_arguments(arg "" "STACK" "FLASH;RAM;SOURCES" ${ARGN})
  if(NOT arg_STACK)
    set(arg_STACK 16384)
  endif()
  set(here ${CMAKE_CURRENT_FUNCTION_LIST_DIR})
  list(GET arg_FLASH 0 flash_origin)
  list(GET arg_FLASH 1 flash_bytes)
  list(GET arg_RAM 0 ram_origin)
  list(GET arg_RAM 1 ram_bytes)

  set_target_properties(${executable} PROPERTIES SUFFIX .elf)
  target_sources(${executable} PRIVATE ${here}/startup.cpp ${here}/faults.cpp ${here}/semihosting.cpp
                                       ${here}/console.cpp ${arg_SOURCES})
  target_compile_options(
    ${executable}
    PRIVATE -Wall -Wextra -Wdouble-promotion $<$<CONFIG:>:-O2> -fno-exceptions -fno-rtti -fno-threadsafe-statics
            -fno-use-cxa-atexit -fno-unwind-tables -fno-asynchronous-unwind-tables -ffunction-sections
            -fdata-sections)
  # The start-up code copies and clears memory itself.
  set_source_files_properties(${here}/startup.cpp TARGET_DIRECTORY ${executable}
                              PROPERTIES COMPILE_OPTIONS -fno-tree-loop-distribute-patterns)
  target_link_options(
    ${executable}
    PRIVATE
    -nostartfiles
    --specs=nano.specs
    -Wl,--gc-sections
    -Wl,--no-warn-rwx-segments
    -Wl,--defsym=eagerx_flash_origin=${flash_origin}
    -Wl,--defsym=eagerx_flash_bytes=${flash_bytes}
    -Wl,--defsym=eagerx_ram_origin=${ram_origin}
    -Wl,--defsym=eagerx_ram_bytes=${ram_bytes}
    -Wl,--defsym=eagerx_stack_bytes=${arg_STACK}
    -Wl,-Map=$<TARGET_FILE_DIR:${executable}>/$<TARGET_FILE_BASE_NAME:${executable}>.map
    -T
    ${here}/cortex-m.ld)
  set_property(TARGET ${executable} APPEND PROPERTY LINK_DEPENDS ${here}/cortex-m.ld)
  eagerx_forbid_heap(${executable})
  if(CMAKE_SIZE)
    add_custom_command(TARGET ${executable} POST_BUILD COMMAND ${CMAKE_SIZE} $<TARGET_FILE:${executable}> VERBATIM)
  endif()
endfunction()

# Cores without a double-precision unit add doubles with libgcc, whose addition is wrong in the last place now
# and then; ours replaces it, so that the bits are those of every other machine.
function(eagerx_use_own_double_addition executable)
  target_sources(${executable} PRIVATE ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../soft_double_add.cpp)
  target_link_options(${executable} PRIVATE
                      -Wl,--wrap=__aeabi_dadd,--wrap=__aeabi_dsub,--wrap=__aeabi_drsub)
endfunction()
