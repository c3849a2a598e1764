# Event files for TensorBoard, read back.
add_test(NAME train.tensorboard COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/tensorboard $<TARGET_FILE:eagerx-train>
                                        $<TARGET_FILE:test_train_pendulum>)
# Builds a library of environments and a program, and trains: a minute and a half.
add_test(NAME train.record COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/record ${PROJECT_BINARY_DIR})
set_tests_properties(train.record PROPERTIES COST 50)
# The same with several whole numbers as actions: a minute.
add_test(NAME train.chosen COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/chosen ${PROJECT_BINARY_DIR})
set_tests_properties(train.chosen PROPERTIES COST 50)
if(EAGERX_MPI)
  add_test(NAME train.mpi COMMAND ${CMAKE_CURRENT_LIST_DIR}/mpi ${PROJECT_BINARY_DIR})
  set_tests_properties(train.mpi PROPERTIES PROCESSORS 2)
endif()
# The same policy for all numbers of threads and instruction sets.
add_test(NAME train.bits COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/bits $<TARGET_FILE:eagerx-train>
                                 $<TARGET_FILE:test_train_pendulum>)
