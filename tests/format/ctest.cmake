add_test(NAME format COMMAND ${PROJECT_SOURCE_DIR}/tests/lint --format-only)
