// GRU and LSTM of an actor, as torch names their parameters: weight_ih_l0, weight_hh_l0,
// bias_ih_l0, bias_hh_l0, and so on for each layer.
#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "generator/policy/formats/actor/actor.hpp"

namespace eagerx::gen {
namespace {

constexpr std::string_view kFirst = ".weight_ih_l0";
constexpr int kMaxMemoryLayers = 16;

std::string name_of(const std::string& base, const char* what, int index) {
  return fmt::format("{}{}{}_l{}", base, base.empty() ? "" : ".", what, index);
}

/// The text before `.weight_ih_l0`.
std::vector<std::string> bases_of(const TensorTable& table) {
  std::vector<std::string> bases;
  for (const auto& [name, tensor] : table.tensors) {
    if (name == kFirst.substr(1)) bases.emplace_back();
    if (name.ends_with(kFirst)) bases.push_back(name.substr(0, name.size() - kFirst.size()));
  }
  return bases;
}

/// Size of dimension `axis` of a matrix that is there; 0 otherwise.
std::int64_t size_of(const TensorTable& table, const std::string& name, std::size_t axis) {
  const StoredTensor* tensor = table.find(name);
  return tensor != nullptr && tensor->shape.size() == 2 ? tensor->shape[axis] : 0;
}

/// The places among the modules whose neighbours have the memory's sizes.
std::vector<std::size_t> places_of(const TensorTable& table, const ActorLayout& layout,
                                   std::int64_t inputs, std::int64_t hidden) {
  std::vector<std::size_t> places;
  // In known layouts the head is the last.
  const bool may_be_last = layout.memory_place == MemoryPlace::unknown;
  for (std::size_t i = 0; i < layout.modules.size() + (may_be_last ? 1 : 0); ++i) {
    const auto weight = [&](std::size_t at) { return layout.modules[at].base + ".weight"; };
    const bool before = i == 0 || size_of(table, weight(i - 1), 0) == inputs;
    const bool after = i == layout.modules.size() || size_of(table, weight(i), 1) == hidden;
    if (before && after) places.push_back(i);
  }
  return places;
}

/// The place of the memory; if sizes fit in several, that of the library. Nothing: several, or
/// none.
std::optional<std::size_t> place_of(const ActorLayout& layout,
                                    const std::vector<std::size_t>& places) {
  if (!layout.memory.empty()) return 0;
  if (places.size() == 1) return places.front();
  const std::size_t wanted =
      layout.memory_place == MemoryPlace::first ? 0 : layout.modules.size() - 1;
  const bool fits = std::find(places.begin(), places.end(), wanted) != places.end();
  if (layout.memory_place == MemoryPlace::unknown || !fits) return std::nullopt;
  return wanted;
}

}  // namespace

bool add_memory(const TensorTable& table, ActorLayout& layout, PolicyProblem& problem) {
  std::vector<std::string> bases = bases_of(table);
  if (!layout.memory.empty()) {
    std::erase_if(bases, [&](const std::string& base) { return base != layout.memory; });
  } else {
    std::erase_if(bases, is_critic);
  }
  if (bases.empty()) return true;
  if (bases.size() > 1) {
    return refuse(
        problem, "E0625",
        fmt::format("has two memories: `{}` and `{}`", printable(bases[0]), printable(bases[1])),
        "save a file with the tensors of one of them");
  }
  const std::string& base = bases.front();
  int count = 0;
  while (count < kMaxMemoryLayers && table.find(name_of(base, "weight_ih", count)) != nullptr)
    ++count;
  const std::int64_t inputs = size_of(table, name_of(base, "weight_ih", 0), 1);
  const std::int64_t hidden = size_of(table, name_of(base, "weight_hh", count - 1), 1);
  const std::vector<std::size_t> places = places_of(table, layout, inputs, hidden);
  const auto place = place_of(layout, places);
  if (!place && places.size() > 1) {
    return refuse(
        problem, "E0625",
        fmt::format("has a memory `{}` from {} to {} values, which fits both before and behind "
                    "other layers",
                    printable(base), inputs, hidden),
        "export the actor to ONNX, which says in which order they are");
  }
  if (!place) {
    return refuse(
        problem, "E0618",
        fmt::format("has a memory `{}` from {} to {} values, which fits between no two of its "
                    "other layers",
                    printable(base), inputs, hidden),
        kOtherActor);
  }
  for (int i = 0; i < count; ++i) {
    layout.modules.insert(layout.modules.begin() + static_cast<std::ptrdiff_t>(*place) + i,
                          ActorModule{base, false, i});
  }
  return true;
}

std::optional<Layer> recurrent_layer(const TensorTable& table, const std::string& base, int index,
                                     std::vector<std::string>& used, PolicyProblem& problem) {
  const std::string input_name = name_of(base, "weight_ih", index);
  const std::string hidden_name = name_of(base, "weight_hh", index);
  const StoredTensor* input = table.find(input_name);
  const StoredTensor* hidden = table.find(hidden_name);
  if (input == nullptr || hidden == nullptr) {
    return refuse(problem, "E0624",
                  fmt::format("has an actor without tensor `{}`",
                              printable(input == nullptr ? input_name : hidden_name)),
                  kOtherActor);
  }
  const auto is_matrix = [](const StoredTensor& tensor) {
    return tensor.shape.size() == 2 && tensor.shape[0] > 0 && tensor.shape[1] > 0;
  };
  const std::int64_t outputs = is_matrix(*hidden) ? hidden->shape[1] : 0;
  const std::int64_t rows = is_matrix(*hidden) ? hidden->shape[0] : 0;
  if (!is_matrix(*input) || outputs == 0 || input->shape[0] != rows) {
    return refuse(problem, "E0618",
                  fmt::format("has tensors `{}` of shape {} and `{}` of shape {}, which do not fit",
                              printable(input_name), show(input->shape), printable(hidden_name),
                              show(hidden->shape)),
                  kOtherActor);
  }
  const std::int64_t gates = rows / outputs;
  const StoredTensor* reverse = table.find(input_name + "_reverse");
  const StoredTensor* projection = table.find(name_of(base, "weight_hr", index));
  if (rows % outputs != 0 || (gates != 3 && gates != 4) || reverse != nullptr ||
      projection != nullptr) {
    return refuse(problem, "E0628",
                  fmt::format("has a memory `{}` that is not a plain GRU or LSTM", printable(base)),
                  "supported are torch's GRU and LSTM, in one direction and without projection");
  }
  Layer layer;
  Recurrence cell;
  cell.is_lstm = gates == 4;
  layer.inputs = static_cast<std::uint32_t>(input->shape[1]);
  layer.outputs = static_cast<std::uint32_t>(outputs);
  auto weights = floats_of(input_name, *input, problem);
  auto hidden_weights = weights ? floats_of(hidden_name, *hidden, problem) : std::nullopt;
  if (!hidden_weights) return std::nullopt;
  layer.weights = std::move(*weights);
  cell.hidden_weights = std::move(*hidden_weights);
  used.push_back(input_name);
  used.push_back(hidden_name);
  for (const auto& [what, values] :
       {std::pair{"bias_ih", &layer.bias}, std::pair{"bias_hh", &cell.hidden_bias}}) {
    const std::string name = name_of(base, what, index);
    const StoredTensor* bias = table.find(name);
    values->assign(static_cast<std::size_t>(rows), 0.0F);
    if (bias == nullptr) continue;  // bias=False
    if (bias->shape != Dims{rows}) {
      return refuse(problem, "E0618",
                    fmt::format("has tensor `{}` of shape {} for {} outputs", printable(name),
                                show(bias->shape), rows),
                    kOtherActor);
    }
    auto numbers = floats_of(name, *bias, problem);
    if (!numbers) return std::nullopt;
    *values = std::move(*numbers);
    used.push_back(name);
  }
  layer.form = std::move(cell);
  return layer;
}

}  // namespace eagerx::gen
