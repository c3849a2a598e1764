#include "targets/environments/train/export.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <nlohmann/json.hpp>

namespace eagerx::train {
namespace {

static_assert(std::endian::native == std::endian::little, "safetensors are little-endian");

using nlohmann::ordered_json;

/// "angle (2), theta_dot"
std::string listed(const std::vector<Space>& spaces) {
  std::string text;
  for (const Space& space : spaces) {
    if (!text.empty()) text += ", ";
    text += space.name;
    if (space.size != 1) text += fmt::format(" ({})", space.size);
  }
  return text;
}

std::string listed(const std::vector<float>& numbers) {
  return fmt::format("{}", fmt::join(numbers, ", "));
}

ordered_json notes_of(const Policy& policy, const Description& description,
                      const Settings& settings) {
  const bool is_relu = policy.network.activation() == Activation::relu;
  ordered_json notes = {{"writer", "eagerx-gen train"}, {"activation", is_relu ? "relu" : "tanh"}};
  if (policy.head.chooses) {
    notes["first_choice"] = listed(policy.head.low);
  } else {
    notes["squash"] = "true";
    notes["low"] = listed(policy.head.low);
    notes["high"] = listed(policy.head.high);
  }
  notes["obs"] = listed(description.observations);
  notes["rate"] = fmt::format("{}", description.rate_hz);
  notes["graph"] = description.graph;
  notes["hash"] = description.hash;
  notes["seed"] = fmt::format("{}", settings.seed);
  notes["settings"] = text_of(settings);
  return notes;
}

void append(std::string& data, ordered_json& header, const std::string& name,
            std::vector<std::size_t> shape, const float* values, std::size_t count) {
  const std::size_t begin = data.size();
  data.append(reinterpret_cast<const char*>(values), count * sizeof(float));
  header[name] = {
      {"dtype", "F32"}, {"shape", std::move(shape)}, {"data_offsets", {begin, data.size()}}};
}

}  // namespace

std::string safetensors_of(const Policy& policy, const Description& description,
                           const Settings& settings) {
  ordered_json header;
  header["__metadata__"] = notes_of(policy, description, settings);
  std::string data;
  const auto& layers = policy.network.layers();
  for (std::size_t k = 0; k < layers.size(); ++k) {
    const auto& [sizes, weights, bias, from, to] = layers[k];
    // Odd places of a torch `Sequential` are its activations.
    const std::string name =
        k + 1 == layers.size() ? "policy.action" : fmt::format("policy.hidden.{}", 2 * k);
    append(data, header, name + ".weight", {sizes.outputs, sizes.inputs},
           &policy.parameters[weights], sizes.outputs * sizes.inputs);
    append(data, header, name + ".bias", {sizes.outputs}, &policy.parameters[bias], sizes.outputs);
  }
  std::string text = header.dump();
  constexpr std::size_t kAlignment = 8;
  text.append((kAlignment - text.size() % kAlignment) % kAlignment, ' ');
  const std::uint64_t length = text.size();
  std::string bytes(sizeof length, '\0');
  std::memcpy(bytes.data(), &length, sizeof length);
  return bytes + text + data;
}

std::string golden_rows(const Policy& policy, const Kernels& kernels,
                        const std::vector<float>& rows) {
  const std::size_t inputs = policy.network.inputs();
  const std::size_t outputs = policy.network.outputs();
  std::string text;
  for (std::size_t i = 0; i < inputs; ++i) text += fmt::format("obs{},", i);
  for (std::size_t j = 0; j < outputs; ++j) text += fmt::format("network_out{},", j);
  const std::size_t numbers = policy.head.numbers;
  for (std::size_t j = 0; j < numbers; ++j) {
    text += fmt::format("action{}{}", j, j + 1 == numbers ? "\n" : ",");
  }
  std::vector<float> action(numbers);
  Packs row(policy.network.row());
  std::vector<float> tile(kLanes * inputs);
  const std::size_t count = rows.size() / inputs;
  for (std::size_t first = 0; first < count; first += kLanes) {
    const std::size_t here = std::min(kLanes, count - first);
    std::copy_n(&rows[first * inputs], here * inputs, tile.data());
    policy.answer(kernels, tile.data(), row.data());
    const Pack* answers = &row[policy.network.output()];
    for (std::size_t l = 0; l < here; ++l) {
      text += fmt::format("{}", fmt::join(&tile[l * inputs], &tile[l * inputs] + inputs, ","));
      for (std::size_t j = 0; j < outputs; ++j) text += fmt::format(",{}", answers[j].lane[l]);
      policy.head.act(answers, l, action.data());
      text += fmt::format(",{}\n", fmt::join(action, ","));
    }
  }
  return text;
}

std::string golden_path(const std::string& path) {
  constexpr std::string_view kEnd = ".safetensors";
  const bool has_end = path.ends_with(kEnd);
  return path.substr(0, has_end ? path.size() - kEnd.size() : path.size()) + ".golden.csv";
}

}  // namespace eagerx::train
