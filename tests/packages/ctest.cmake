# A generated tree in an empty folder, and as a package of Arduino, ESP-IDF, PlatformIO and Zephyr.
add_test(NAME packages COMMAND ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:eagerx-gen>)
set_tests_properties(packages PROPERTIES COST 1000) # long: first
