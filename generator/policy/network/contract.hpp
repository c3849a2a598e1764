// The world that a policy was trained in: its observations, their normalization, and its outputs.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace eagerx::gen {

/// A part of an observation.
struct NamedPart {
  std::string name;
  std::uint64_t size = 1;
};

/// clip((x - mean) / sqrt(variance + epsilon), -clip, clip) in float64: VecNormalize.
struct Normalization {
  std::vector<double> mean;      // [inputs]
  std::vector<double> variance;  // [inputs]
  double clip = 10.0;
  double epsilon = 1e-8;
  std::string source;              // file, as the user wrote it
  std::vector<NamedPart> parts{};  // of a Dict, in order; else empty
};

/// How the network's outputs become an action.
enum class ActionKind : std::uint8_t {
  raw,       // clipped to the bounds: PPO, A2C
  squashed,  // from -1…1 to the bounds: SAC, TD3
  argmax,    // the index of the largest one, of all or of each group: DQN, discrete PPO
  binary,    // 1 where it is above zero, else 0: PPO on a MultiBinary
};
const char* to_string(ActionKind kind);
/// Whether actions are whole numbers that depend on which outputs are larger.
constexpr bool is_choice(ActionKind kind) {
  return kind == ActionKind::argmax || kind == ActionKind::binary;
}

/// The file's facts of the environment of its training; empty where unknown.
struct PolicyContract {
  std::string algorithm;                                  // "SAC"
  std::vector<NamedPart> observations;                    // in the order of the inputs
  std::vector<double> action_low, action_high;            // one for each output, or for all
  std::vector<double> observation_low, observation_high;  // one for each input, or empty
  /// How many whole numbers from 0 on an input may be, 0 for any number; one for each, or empty.
  std::vector<std::uint32_t> choices{};
  /// argmax: the value of the first output of each choice; one value: of all choices. Empty:
  /// unknown.
  std::vector<std::int64_t> first_choices{};
  /// argmax: how many outputs each choice is among, in order: two or more of a MultiDiscrete.
  /// Empty: not known.
  std::vector<std::uint32_t> groups{};
  std::optional<double> rate_hz;  // steps a second in training

  /// Of choice `i`: 0 where it is not known.
  [[nodiscard]] std::int64_t first_choice(std::size_t i = 0) const {
    return first_choices.empty() ? 0 : first_choices[first_choices.size() == 1 ? 0 : i];
  }
};

}  // namespace eagerx::gen
