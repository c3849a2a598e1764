# The trainer, and a library of environments for it that is written by hand.
target_link_libraries(test_train PRIVATE eagerx_train)
add_library(test_train_pendulum MODULE ${CMAKE_CURRENT_SOURCE_DIR}/unit/train/pendulum_library.cpp)
target_link_libraries(test_train_pendulum PRIVATE eagerx_warnings eagerx::runtime)
target_include_directories(test_train_pendulum PRIVATE ${PROJECT_SOURCE_DIR})
target_compile_options(test_train_pendulum PRIVATE -O2)
add_dependencies(test_train test_train_pendulum)
target_compile_definitions(test_train PRIVATE EAGERX_TEST_PENDULUM="$<TARGET_FILE:test_train_pendulum>")
add_test(NAME train_symbols COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/unit/train/symbols.sh $<TARGET_OBJECTS:eagerx_train>
         COMMAND_EXPAND_LISTS)
