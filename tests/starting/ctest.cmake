# The page "Your first robot in fifteen minutes", word for word.
add_test(NAME starting.first_robot COMMAND ${CMAKE_CURRENT_LIST_DIR}/follow ${PROJECT_BINARY_DIR})
