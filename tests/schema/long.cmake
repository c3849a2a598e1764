# JSON schemas of a library's graphs and of manifests.
add_test(NAME schema COMMAND /usr/bin/python3 ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:eagerx-gen>)
