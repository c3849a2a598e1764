# The tests build and break ONNX models themselves.
target_link_libraries(test_${name} PRIVATE eagerx_gen_onnx_messages)
find_package(ZLIB REQUIRED)
target_link_libraries(test_${name} PRIVATE ZLIB::ZLIB)
