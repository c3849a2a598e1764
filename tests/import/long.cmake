# Large files that EAGERx saved, imported or refused with all reasons.
add_test(NAME import_packed COMMAND ${CMAKE_CURRENT_LIST_DIR}/packed/run $<TARGET_FILE:eagerx-gen>)
