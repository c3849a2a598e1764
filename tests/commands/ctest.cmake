# Errors in command lines, and the commands that the messages suggest.
add_test(NAME commands COMMAND ${CMAKE_CURRENT_LIST_DIR}/run ${PROJECT_BINARY_DIR})
# A full disk, closed descriptors, and characters that steer terminals.
add_test(NAME commands_full_disk COMMAND ${CMAKE_CURRENT_LIST_DIR}/full_disk ${PROJECT_BINARY_DIR})
# No ccache that cannot write.
add_test(NAME commands_compiler_cache COMMAND ${CMAKE_CURRENT_LIST_DIR}/compiler_cache ${PROJECT_BINARY_DIR})
# Two commands in one folder, each of which runs what it was asked for.
add_test(NAME commands_at_once COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/at_once ${PROJECT_BINARY_DIR})
# Closed descriptors, a deleted folder, little memory.
if(NOT EAGERX_SANITIZE) # sanitizers reserve more address space
  add_test(NAME commands_closed COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/closed ${PROJECT_BINARY_DIR})
endif()
# Every pair of commands in one folder.
add_test(NAME commands_pairs COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/pairs ${PROJECT_BINARY_DIR})
# A library in the cache that is cut short.
add_test(NAME commands_kept_library COMMAND ${CMAKE_CURRENT_LIST_DIR}/kept_library)
# READMEs say of commands and options what the help says.
add_test(NAME commands_documented COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/documented ${PROJECT_BINARY_DIR})
# Former names in files and on command lines, and what `fix` makes of them.
add_test(NAME commands_renamed COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/renamed ${PROJECT_BINARY_DIR})
# Files and lists of an earlier version: tests/data/stability.
add_test(NAME commands_stability COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/stability ${PROJECT_BINARY_DIR})
# Vectorized environments for this processor alone.
add_test(NAME commands_instruction_sets COMMAND ${CMAKE_CURRENT_LIST_DIR}/instruction_sets ${PROJECT_BINARY_DIR})
