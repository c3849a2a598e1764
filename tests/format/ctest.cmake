add_test(NAME format COMMAND ${PROJECT_SOURCE_DIR}/tests/lint --format-only)
# With another version of clang-format.
set_tests_properties(format PROPERTIES SKIP_RETURN_CODE 77)
