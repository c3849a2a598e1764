// What a reader may need besides the bytes of a file.
#pragma once

#include <optional>
#include <string>

#include "generator/network/layer.hpp"

namespace eagerx::gen {

struct ReadContext {
  std::optional<Activation> activation{};         // of hidden layers, as the graph says
  std::string actor{};                            // of tables: how the names of its tensors begin
  std::string output_name{};                      // of ONNX: which output is the action
  std::optional<Activation> output_activation{};  // after the last layer, as the graph says
};

}  // namespace eagerx::gen
