# The reference: every link leads somewhere, every entity and key has its place, twice the same bytes.
add_test(NAME site COMMAND /usr/bin/python3 -B ${CMAKE_CURRENT_LIST_DIR}/run ${PROJECT_BINARY_DIR}/eagerx-gen)
add_test(NAME site.falsified COMMAND /usr/bin/python3 -B ${CMAKE_CURRENT_LIST_DIR}/falsify)
