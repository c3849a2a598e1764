# All cases, also those without a fix, which must not get one unseen.
add_test(NAME diagnostics.fixes_of_all COMMAND ${CMAKE_CURRENT_LIST_DIR}/fixes $<TARGET_FILE:eagerx-gen> --all)
# Applies the help of each message to the file of its case.
add_test(NAME diagnostics.helps COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/helps $<TARGET_FILE:eagerx-gen>)
