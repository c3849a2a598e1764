# Settings of a training that do not go together, at their places.
add_test(NAME commands_settings COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/settings ${PROJECT_BINARY_DIR}
                                        $<TARGET_FILE:test_train_pendulum>)
# Full disks under every output, on disks that are mounted for it, which is not allowed everywhere.
if(NOT EAGERX_SANITIZE) # a library that is opened by programs without sanitizers
  add_test(NAME commands_full_files COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/full_files ${PROJECT_BINARY_DIR}
                                            $<TARGET_FILE:environments_swing> $<TARGET_FILE:environments_swing_alone>)
  set_tests_properties(commands_full_files PROPERTIES SKIP_RETURN_CODE 77)
  # Links, devices, FIFOs, foreign files in the place of every output.
  add_test(NAME commands_every_kind COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/every_kind ${PROJECT_BINARY_DIR}
                                            $<TARGET_FILE:environments_swing> $<TARGET_FILE:environments_swing_alone>)
  # Two programs with one output.
  add_test(NAME commands_two_writers COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/two_writers ${PROJECT_BINARY_DIR}
                                             $<TARGET_FILE:environments_swing> $<TARGET_FILE:environments_swing_alone>)
endif()
# A node that writes beyond its message.
if(NOT EAGERX_SANITIZE)
  add_test(NAME commands_sanitized COMMAND ${CMAKE_CURRENT_LIST_DIR}/sanitized ${PROJECT_BINARY_DIR})
endif()
add_test(NAME commands_at_once_all COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/at_once ${PROJECT_BINARY_DIR} --all)
# No output on an input or on another output, in any command.
add_test(NAME commands_one_file COMMAND ${CMAKE_CURRENT_LIST_DIR}/one_file ${PROJECT_BINARY_DIR})
# The work of a check grows with the number of problems, not with its square.
find_program(VALGRIND valgrind)
if(VALGRIND AND NOT EAGERX_SANITIZE)
  add_test(NAME commands_linear COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/linear ${PROJECT_BINARY_DIR}
           "nodes without rate" "unknown owners" "unknown sensors" "connected twice")
endif()
# The trace hash of an earlier version.
add_test(NAME commands_stable_hash COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/stability ${PROJECT_BINARY_DIR} --run)
# Every spelling of a name, in every command.
if(NOT EAGERX_SANITIZE) # a library that is opened by programs without sanitizers
  block()
  include(${PROJECT_SOURCE_DIR}/tests/support/quick_simd.cmake)
  eagerx_add_graph(TARGET commands_spelled GRAPH ${CMAKE_CURRENT_LIST_DIR}/spelled.yaml)
  eagerx_add_graph(TARGET commands_spelled_many GRAPH ${CMAKE_CURRENT_LIST_DIR}/spelled.yaml BOARD environments)
  endblock()
  add_test(NAME commands_spellings COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/spellings ${PROJECT_BINARY_DIR}
                                           $<TARGET_FILE:commands_spelled> $<TARGET_FILE:commands_spelled_many>)
endif()
