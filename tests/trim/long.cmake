# Operating points against closed forms, and margins in a budget.
add_test(NAME trim COMMAND ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:eagerx-gen>)
