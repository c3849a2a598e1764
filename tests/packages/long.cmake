# A generated tree in an empty folder, and as a package of Arduino, ESP-IDF, PlatformIO and Zephyr; main loops for
# hardware as such packages.
add_test(NAME packages COMMAND ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:eagerx-gen>)
add_test(NAME packages.loops COMMAND ${CMAKE_CURRENT_LIST_DIR}/loops/run $<TARGET_FILE:eagerx-gen>)
add_test(NAME packages.headers COMMAND ${CMAKE_CURRENT_LIST_DIR}/headers/run $<TARGET_FILE:eagerx-gen>)
set_tests_properties(packages packages.loops PROPERTIES COST 1000) # first
