// Inputs of a graph. Inside formats/onnx only.
#pragma once

#include <optional>

#include "generator/policy/formats/onnx/onnx.pb.h"
#include "generator/policy/network/graph/value.hpp"

namespace eagerx::gen {

/// The help for graphs that are more than an actor.
inline constexpr const char* kExportActor =
    "export the actor alone with `torch.onnx.export`: one observation in, the action first";

/// The shape of one observation: a batch axis becomes 1, and so does one of time, if there is a
/// memory. E0608.
std::optional<Dims> input_shape(const onnx::ValueInfoProto& input, bool has_memory,
                                PolicyProblem& problem);

/// Whether batch and time are axes of any length.
bool is_sequence(const onnx::ValueInfoProto& input);

/// The state of the layers of a GRU or LSTM: [layers, 1, values]. E0608.
std::optional<NetValue> state_value(const onnx::ValueInfoProto& input, PolicyProblem& problem);

}  // namespace eagerx::gen
