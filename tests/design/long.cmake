# `eagerx-gen design` on graphs whose programs it builds: gains against closed forms, margins as they were asked for.
add_test(NAME design COMMAND ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:eagerx-gen>)
set_tests_properties(design PROPERTIES COST 120)
add_test(NAME design.regulators COMMAND ${CMAKE_CURRENT_LIST_DIR}/scipy $<TARGET_FILE:eagerx-gen> --regulators)
set_tests_properties(design.regulators PROPERTIES SKIP_RETURN_CODE 77 COST 120)
