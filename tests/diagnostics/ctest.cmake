# Messages about broken graphs. Every code must have a page and a test.
add_test(NAME diagnostics COMMAND ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:eagerx-gen>)
add_test(NAME diagnostics.codes COMMAND ${CMAKE_CURRENT_LIST_DIR}/codes $<TARGET_FILE:eagerx-gen>)
add_test(NAME diagnostics.causes COMMAND ${CMAKE_CURRENT_LIST_DIR}/causes $<TARGET_FILE:eagerx-gen>)
add_test(NAME diagnostics.fixes COMMAND ${CMAKE_CURRENT_LIST_DIR}/fixes $<TARGET_FILE:eagerx-gen>)
