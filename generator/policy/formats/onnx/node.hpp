// ONNX's messages as operators and tensors of the network's graph. Inside formats/onnx only.
#pragma once

#include <deque>

#include "generator/policy/formats/onnx/onnx.pb.h"
#include "generator/policy/network/graph/call.hpp"

namespace eagerx::gen {

/// A tensor as a constant, after checking type, dimensions and amount of data (not the values);
/// otherwise its `problem` is E0614, E0615 or E0617. `made` stores its description.
NetValue tensor_value(const onnx::TensorProto& tensor, std::deque<NetTensor>& made);

/// A node of a file of version `opset`, with views into the file. Its `inputs` may become fewer.
NetNode node_of(const onnx::NodeProto& node, std::int64_t opset,
                std::vector<const NetValue*>& inputs, std::deque<NetTensor>& made);

}  // namespace eagerx::gen
