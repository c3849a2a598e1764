# `eagerx-gen check --compile`: what entities promise, with the place of what breaks it.
add_test(NAME compile COMMAND ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:eagerx-gen>)
set_tests_properties(compile PROPERTIES COST 120)
