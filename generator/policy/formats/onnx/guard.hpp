// Checks that an ONNX file can be parsed in little memory. Inside formats/onnx only.
#pragma once

#include <string_view>

namespace eagerx::gen {

/// False if protobuf would make more objects from `bytes` than a network can need: two bytes of a
/// file become a node of 150 bytes in memory. True for damaged bytes, which protobuf reports.
bool is_onnx_of_few_parts(std::string_view bytes);

}  // namespace eagerx::gen
