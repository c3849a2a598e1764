# Event files for TensorBoard, read back.
add_test(NAME train.tensorboard COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/tensorboard $<TARGET_FILE:eagerx-train>
                                        $<TARGET_FILE:test_train_pendulum>)
