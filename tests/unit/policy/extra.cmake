# The tests build and break ONNX models themselves.
find_package(Protobuf REQUIRED)
find_package(ONNX REQUIRED)
target_link_libraries(test_${name} PRIVATE onnx_proto protobuf::libprotobuf)
find_package(ZLIB REQUIRED)
target_link_libraries(test_${name} PRIVATE ZLIB::ZLIB)
