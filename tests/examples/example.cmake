# eagerx_test_example(EXAMPLE): its programs for Linux, and the test that they do what it says.
function(eagerx_test_example example)
  if(EAGERX_SANITIZE AND EXISTS ${PROJECT_SOURCE_DIR}/examples/${example}/programs)
    # Its emulator has a clock of its own, which the sanitizer asks before it is there (tests/ftdi).
    file(STRINGS ${PROJECT_SOURCE_DIR}/examples/${example}/programs hardware REGEX RealEngine)
    if(hardware)
      return()
    endif()
  endif()
  eagerx_add_example(${example} WITHOUT_BOARDS)
  add_test(NAME examples.${example} COMMAND ${PROJECT_SOURCE_DIR}/examples/${example}/evaluate ${EAGERX_EXAMPLE_PROGRAMS})
  set_tests_properties(examples.${example} PROPERTIES LABELS examples ENVIRONMENT EAGERX_GEN=$<TARGET_FILE:eagerx-gen>)
endfunction()
