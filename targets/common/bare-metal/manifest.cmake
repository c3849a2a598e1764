# Reads the properties of a board from its manifest.yaml, their only source.

# eagerx_board_memory(<variable> <folder> <flash|ram>): ORIGIN and SIZE as a list, from the line
# `flash: [ORIGIN, SIZE]`. A board whose blanks are not filled in does not build.
function(eagerx_board_memory variable folder name)
  _eagerx_manifest_line(line ${folder} ${name})
  if(NOT line MATCHES "^\\[ *(0x[0-9a-fA-F]+) *, *([0-9]+) *([kKM]?)i?B? *\\]$")
    message(FATAL_ERROR "${folder}/manifest.yaml: `${name}` is `${line}`; fill in [ORIGIN, SIZE], such as "
                        "[0x08000000, 512K]")
  endif()
  set(${variable} ${CMAKE_MATCH_1} ${CMAKE_MATCH_2}${CMAKE_MATCH_3} PARENT_SCOPE)  # as the linker reads it
endfunction()

# eagerx_board_number(<variable> <folder> <key>): a whole number from the line `key: NUMBER`.
function(eagerx_board_number variable folder name)
  _eagerx_manifest_line(line ${folder} ${name})
  if(NOT line MATCHES "^[1-9][0-9]*$")
    message(FATAL_ERROR "${folder}/manifest.yaml: `${name}` is `${line}`; fill in a whole number")
  endif()
  set(${variable} ${line} PARENT_SCOPE)
endfunction()

function(_eagerx_manifest_line variable folder name)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${folder}/manifest.yaml)
  # Not file(STRINGS): brackets would glue lines together.
  file(READ ${folder}/manifest.yaml text)
  set(value)
  if("\n${text}" MATCHES "\n${name}:[ \t]*([^\n#]*)")
    string(STRIP "${CMAKE_MATCH_1}" value)
  endif()
  set(${variable} "${value}" PARENT_SCOPE)
endfunction()
