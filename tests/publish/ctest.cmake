# Messages that programs publish while they run. tests/publish/run tests real time, with readers that hang.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
set(guarded)
if(TARGET no_alloc_swing_up)
  set(guarded $<TARGET_FILE:no_alloc_swing_up>)
endif()
add_test(NAME publish COMMAND Python3::Interpreter ${CMAKE_CURRENT_LIST_DIR}/check $<TARGET_FILE:eagerx-gen>
                              $<TARGET_FILE:replay_swing_up> ${guarded})
