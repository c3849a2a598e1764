# Every example does what it says, on Linux: ctest -L examples
include(${PROJECT_SOURCE_DIR}/examples/examples.cmake)
eagerx_find_examples(examples)
foreach(example IN LISTS examples)
  eagerx_add_example(${example} WITHOUT_BOARDS)
  add_test(NAME examples.${example} COMMAND ${PROJECT_SOURCE_DIR}/examples/${example}/evaluate ${EAGERX_EXAMPLE_PROGRAMS})
  set_tests_properties(examples.${example} PROPERTIES LABELS examples ENVIRONMENT EAGERX_GEN=$<TARGET_FILE:eagerx-gen>)
endforeach()
