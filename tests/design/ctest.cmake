# `eagerx-gen design`: ten filters against SciPy, without a program.
add_test(NAME design.scipy COMMAND ${CMAKE_CURRENT_LIST_DIR}/scipy $<TARGET_FILE:eagerx-gen>)
set_tests_properties(design.scipy PROPERTIES SKIP_RETURN_CODE 77)
