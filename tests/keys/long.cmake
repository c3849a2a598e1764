# Every key does something, or something is said of it.
add_executable(print_formats ${CMAKE_CURRENT_LIST_DIR}/print_formats.cpp)
target_link_libraries(print_formats PRIVATE eagerx_gen_frontend)
add_test(NAME keys COMMAND ${CMAKE_CURRENT_LIST_DIR}/run $<TARGET_FILE:eagerx-gen> $<TARGET_FILE:print_formats>)
set_tests_properties(keys PROPERTIES COST 130)
