// Tensors of an actor's file that no layer uses.
#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "generator/policy/formats/actor/parts.hpp"

namespace eagerx::gen {

bool is_for_training(std::string_view name) {
  const auto has = [&](std::string_view part) { return name.find(part) != std::string_view::npos; };
  constexpr std::array kParts = {"critic",
                                 "value",
                                 "vf_",
                                 "target",
                                 "logstd",
                                 "sigma",
                                 "rnd.",
                                 "num_batches_tracked",
                                 "ret_rms",
                                 "discriminator",
                                 ".steps",
                                 "memory_c",
                                 ".c_rnn",
                                 ".c_layer_norm",
                                 "_disc_mlp",
                                 "_disc_logits",
                                 "returns_normalizer"};
  if (std::any_of(kParts.begin(), kParts.end(), has)) return true;
  if (has("std") && !has("obs") && !has("norm") && !has("mean")) return true;
  constexpr std::array kNotes = {"low",      "high",  "rate",  "squash",
                                 "clip_obs", "gamma", "count", "epsilon"};
  return std::find(kNotes.begin(), kNotes.end(), name) != kNotes.end();
}

namespace {

bool may_be_left(const ActorParts& parts, const ActorLayout& layout, std::string_view name) {
  if (layout.is_said || is_for_training(name)) return true;
  // PPO's extractor is there under several names; skrl's critic may see more than its actor.
  const bool again = !layout.extractor.empty() && !parts.network.input_shape.empty() &&
                     name.starts_with("features_extractor.");
  return again || (name.starts_with("state_preprocessor.") &&
                   parts.table.find("observation_preprocessor.running_mean") != nullptr);
}

}  // namespace

bool check_rest(const ActorParts& parts, const ActorLayout& layout) {
  for (const auto& [name, tensor] : parts.table.tensors) {
    if (parts.used.count(name) > 0 || may_be_left(parts, layout, name)) continue;
    return parts.fail("E0628",
                      fmt::format("has parts that are not supported: `{}`", printable(name)),
                      "layers are Linear, LayerNorm, BatchNorm, GRU, LSTM and NatureCNN; give "
                      "statistics as `normalize`, say the layers of the actor in their order "
                      "(`layers: […]`), or export the actor to ONNX");
  }
  for (const auto& [name, tensor] : parts.table.tensors) {
    if (parts.used.count(name) > 0) continue;
    parts.network.ignored.push_back(
        fmt::format("tensor `{}` {}", printable(name), show(tensor.shape)));
  }
  return true;
}

}  // namespace eagerx::gen
