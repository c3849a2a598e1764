# Includes and links that go backwards are found.
add_test(NAME architecture.falsified COMMAND ${CMAKE_CURRENT_LIST_DIR}/falsify ${PROJECT_BINARY_DIR})
