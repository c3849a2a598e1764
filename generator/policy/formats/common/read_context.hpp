// Data that a reader may need besides the bytes of a file.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "generator/policy/network/layer.hpp"

namespace eagerx::gen {

/// The bytes of the file with this name in the policy's folder; nothing, and why not ("which is no
/// file").
using FilesInFolder =
    std::function<std::optional<std::string>(const std::string& name, std::string& why)>;

struct ReadContext {
  std::optional<Activation> activation{};  // of hidden layers, as the graph says
  std::string actor{};                     // of tables: how the names of its tensors begin
  std::string output_name{};               // of ONNX and TorchScript: which output is the action
  std::optional<Activation> output_activation{};  // after the last layer, as the graph says
  bool state_dependent_std = false;               // outputs are means, then as many deviations
  std::vector<std::int64_t> input_sizes{};  // of TorchScript: numbers of each argument of forward
  /// Of tables: modules in the order of evaluation, "fc1"; activations between them, if any is
  /// named, else `activation` follows all but the last.
  std::vector<std::string> layers{};
  bool has_answers = false;  // known answers will be compared with those of the network
  FilesInFolder files{};     // of ONNX, whose values may be in others
};

}  // namespace eagerx::gen
