// Checks that an ONNX file can be parsed in little memory. Inside formats/onnx only.
#pragma once

#include <string_view>

namespace eagerx::gen {

/// False if protobuf would make more objects of `bytes` than a network can need: two bytes of a
/// file become a node of 150 bytes in memory. True for what is damaged: protobuf says so.
bool is_onnx_of_few_parts(std::string_view bytes);

}  // namespace eagerx::gen
