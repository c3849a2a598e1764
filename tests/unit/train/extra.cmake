# The trainer, and libraries of environments for it that are written by hand.
target_link_libraries(test_train PRIVATE eagerx_train eagerx_gen_policy)
foreach(library pendulum choices several hidden critic stages staged_critic)
  add_library(test_train_${library} MODULE ${PROJECT_SOURCE_DIR}/tests/unit/train/pendulum_library.cpp)
  target_link_libraries(test_train_${library} PRIVATE eagerx_warnings eagerx::runtime)
  target_include_directories(test_train_${library} PRIVATE ${PROJECT_SOURCE_DIR})
  target_compile_options(test_train_${library} PRIVATE -O2)
  add_dependencies(test_train test_train_${library})
endforeach()
target_compile_definitions(test_train_choices PRIVATE EAGERX_TEST_CHOICES)
target_compile_definitions(test_train_several PRIVATE EAGERX_TEST_SEVERAL)
target_compile_definitions(test_train_hidden PRIVATE EAGERX_TEST_HIDDEN)
target_compile_definitions(test_train_stages PRIVATE EAGERX_TEST_STAGES)
target_compile_definitions(test_train_critic PRIVATE EAGERX_TEST_CRITIC)
target_compile_definitions(test_train_staged_critic PRIVATE EAGERX_TEST_STAGES EAGERX_TEST_CRITIC)
target_compile_definitions(test_train PRIVATE EAGERX_TEST_PENDULUM="$<TARGET_FILE:test_train_pendulum>"
                                              EAGERX_TEST_CHOICES="$<TARGET_FILE:test_train_choices>"
                                              EAGERX_TEST_SEVERAL="$<TARGET_FILE:test_train_several>"
                                              EAGERX_TEST_STAGES="$<TARGET_FILE:test_train_stages>"
                                              EAGERX_TEST_STAGED_CRITIC="$<TARGET_FILE:test_train_staged_critic>"
                                              EAGERX_TEST_HIDDEN="$<TARGET_FILE:test_train_hidden>"
                                              EAGERX_TEST_CRITIC="$<TARGET_FILE:test_train_critic>")
add_test(NAME train_symbols COMMAND ${PROJECT_SOURCE_DIR}/tests/unit/train/symbols.sh $<TARGET_OBJECTS:eagerx_train>
         COMMAND_EXPAND_LISTS)
