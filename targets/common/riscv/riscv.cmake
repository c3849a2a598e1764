# Shared by all bare-metal RISC-V boards.
include_guard(DIRECTORY)
include(${CMAKE_CURRENT_LIST_DIR}/../bare-metal/bare_metal.cmake)

# eagerx_configure_riscv(<executable> FOLDER <the board's> [STACK <bytes>] SOURCES <the board's own>...)
# Memories and clock come from FOLDER/manifest.yaml. libgcc's soft doubles round correctly here: that addition is
# written in C, not in assembly as on Arm.
function(eagerx_configure_riscv executable)
  cmake_parse_arguments(arg "" "FOLDER;STACK" "SOURCES" ${ARGN})
  set(here ${CMAKE_CURRENT_FUNCTION_LIST_DIR})
  eagerx_configure_bare_metal(
    ${executable}
    FOLDER ${arg_FOLDER}
    LINKER_SCRIPT ${here}/riscv.ld
    STARTUP ${here}/startup.cpp
    SOURCES ${here}/traps.cpp ${here}/clock.cpp ${arg_SOURCES}
    STACK ${arg_STACK}
    LINK_OPTIONS -nodefaultlibs)
  target_link_libraries(${executable} PRIVATE -Wl,--start-group -lc -lgcc -Wl,--end-group)
endfunction()
