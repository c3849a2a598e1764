# Shared by all Cortex-M boards.
include_guard(DIRECTORY)
include(${CMAKE_CURRENT_LIST_DIR}/../bare-metal/bare_metal.cmake)

# eagerx_configure_cortex_m(<executable> FOLDER <the board's> [STACK <bytes>] SOURCES <the board's own>...)
# Memories and clock come from FOLDER/manifest.yaml.
function(eagerx_configure_cortex_m executable)
  cmake_parse_arguments(arg "" "FOLDER;STACK" "SOURCES" ${ARGN})
  set(here ${CMAKE_CURRENT_FUNCTION_LIST_DIR})
  eagerx_configure_bare_metal(
    ${executable}
    FOLDER ${arg_FOLDER}
    LINKER_SCRIPT ${here}/cortex-m.ld
    STARTUP ${here}/startup.cpp
    SOURCES ${here}/faults.cpp ${here}/clock.cpp ${arg_SOURCES}
    STACK ${arg_STACK}
    LINK_OPTIONS --specs=nano.specs)
endfunction()

# Cores without a double-precision unit add doubles with libgcc, whose addition is wrong in the last place now
# and then; ours replaces it, so that the bits are those of every other machine.
function(eagerx_use_own_double_addition executable)
  eagerx_board_library(eagerx_double_addition SOURCES ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../soft_double_add.cpp)
  # All of it: what calls it may be libgcc alone, which the linker looks at last.
  target_link_libraries(${executable} PRIVATE -Wl,--whole-archive eagerx_double_addition -Wl,--no-whole-archive)
  target_link_options(${executable} PRIVATE
                      -Wl,--wrap=__aeabi_dadd,--wrap=__aeabi_dsub,--wrap=__aeabi_drsub)
endfunction()
