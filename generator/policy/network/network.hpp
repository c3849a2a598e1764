// A trained policy as plain data: the contents of a weight file, checked.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "generator/policy/network/contract.hpp"
#include "generator/policy/network/layer.hpp"

namespace eagerx::gen {

/// How a program calculates a policy: with the same bits on every machine, or as fast as this one
/// can.
enum class Profile : std::uint8_t { exact, fast };

/// Layers, each after its inputs; the last one outputs the action. Usually a chain: n_obs values
/// in, n_act values out.
struct Network {
  std::string file;                    // as the user wrote it
  std::string format;                  // for people: "ONNX opset 17, exported by pytorch 1.13"
  std::vector<Layer> layers;           // at least one; sizes fit together
  std::vector<std::string> ignored;    // parts of the file that do not lead to the action
  std::vector<std::string> assumed{};  // what the file does not say, for people
  std::optional<ActionKind> action{};  // if the file says it, or its library
  std::string action_of{};             // that library; empty: the file
  std::optional<Normalization> normalization{};
  Profile profile = Profile::exact;
  PolicyContract contract{};
  /// Observations whose answers every program checks on its machine.
  std::vector<std::vector<float>> self_test{};
  /// Of the observation where it matters: channels first.
  std::vector<std::uint32_t> input_shape{};

  /// Whether the answer depends on the observations before, since the start of the episode.
  [[nodiscard]] bool has_memory() const {
    return std::any_of(layers.begin(), layers.end(),
                       [](const Layer& layer) { return layer.remembers() > 0; });
  }
  /// Whether every layer takes the result of the one before it, and the first the observation.
  [[nodiscard]] bool is_chain() const {
    return std::all_of(layers.begin(), layers.end(),
                       [](const Layer& layer) { return layer.takes.empty(); });
  }
  /// Values that layer `i` takes: -1 the observation, k the result of layer k.
  [[nodiscard]] std::vector<std::int32_t> taken_by(std::size_t i) const {
    if (!layers[i].takes.empty()) return layers[i].takes;
    return {static_cast<std::int32_t>(i) - 1};
  }
  /// The first layer always takes the whole observation.
  [[nodiscard]] std::uint32_t inputs() const { return layers.front().inputs; }
  [[nodiscard]] std::uint32_t outputs() const { return layers.back().outputs; }
  /// For `argmax`: the number of outputs of each choice; all of them if unknown.
  [[nodiscard]] std::vector<std::uint32_t> groups() const {
    return contract.groups.empty() ? std::vector{outputs()} : contract.groups;
  }
  /// How many numbers an action has.
  [[nodiscard]] std::size_t actions() const {
    return action_kind() == ActionKind::argmax ? groups().size() : std::size_t{outputs()};
  }
  /// As in the file; else squashed if the last layer is a tanh.
  [[nodiscard]] ActionKind action_kind() const {
    const bool tanh = layers.back().activation == Activation::tanh;
    return action.value_or(tanh ? ActionKind::squashed : ActionKind::raw);
  }
};

}  // namespace eagerx::gen
