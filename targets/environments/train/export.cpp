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

constexpr std::size_t kEpisode = 16;  // golden rows, of a policy that remembers

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
    if (policy.head.numbers > 1)
      notes["choices"] = fmt::format("{}", fmt::join(policy.head.counts, ", "));
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

/// As torch names a GRU's or LSTM's.
void append_memory(std::string& data, ordered_json& header, const Policy& policy,
                   const Cell& cell) {
  for (const auto& [end, product] :
       {std::pair("ih_l0", cell.from_input()), {"hh_l0", cell.from_state()}}) {
    const auto [inputs, outputs] = product.sizes;
    const float* parameters = policy.parameters.data();
    append(data, header, fmt::format("policy.memory.weight_{}", end), {outputs, inputs},
           parameters + product.weights, outputs * inputs);
    append(data, header, fmt::format("policy.memory.bias_{}", end), {outputs},
           parameters + product.bias, outputs);
  }
}

std::string golden_header(const Policy& policy) {
  std::string text = policy.network.memory() != nullptr ? "episode_start," : "";
  for (std::size_t i = 0; i < policy.network.inputs(); ++i) text += fmt::format("obs{},", i);
  for (std::size_t j = 0; j < policy.network.outputs(); ++j)
    text += fmt::format("network_out{},", j);
  const std::size_t numbers = policy.head.numbers;
  for (std::size_t j = 0; j < numbers; ++j)
    text += fmt::format("action{}{}", j, j + 1 == numbers ? "\n" : ",");
  return text;
}

/// The answers of a lane, and the action.
std::string answered(const Policy& policy, const Simd* answers, std::size_t lane) {
  std::string text;
  std::vector<float> action(policy.head.numbers);
  for (std::size_t j = 0; j < policy.network.outputs(); ++j)
    text += fmt::format(",{}", answers[j].lane[lane]);
  policy.head.act(answers, lane, action.data());
  return text + fmt::format(",{}\n", fmt::join(action, ","));
}

}  // namespace

std::string safetensors_of(const Policy& policy, const Description& description,
                           const Settings& settings) {
  ordered_json header;
  header["__metadata__"] = notes_of(policy, description, settings);
  std::string data;
  if (const Cell* cell = policy.network.memory()) append_memory(data, header, policy, *cell);
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
  const bool remembers = policy.network.memory() != nullptr;
  const std::size_t steps = remembers ? kEpisode : 1;  // rows of a lane
  const std::size_t count = rows.size() / inputs;
  std::string text = golden_header(policy);
  std::vector<float> tile(kLanes * inputs);
  for (std::size_t first = 0; first < count; first += kLanes * steps) {
    Simds row(policy.network.row());
    std::vector<std::string> lines(std::min(kLanes * steps, count - first));
    for (std::size_t t = 0; t < steps; ++t) {
      for (std::size_t i = t; i < lines.size(); i += steps)
        std::copy_n(&rows[(first + i) * inputs], inputs, &tile[i / steps * inputs]);
      policy.answer(kernels, tile.data(), row.data());
      for (std::size_t i = t; i < lines.size(); i += steps) {
        const std::size_t l = i / steps;
        lines[i] = remembers ? (t == 0 ? "1," : "0,") : "";
        lines[i] +=
            fmt::format("{}", fmt::join(&tile[l * inputs], &tile[l * inputs] + inputs, ","));
        lines[i] += answered(policy, &row[policy.network.output()], l);
      }
    }
    for (const std::string& line : lines) text += line;
  }
  return text;
}

std::string golden_path(const std::string& path) {
  constexpr std::string_view kEnd = ".safetensors";
  const bool has_end = path.ends_with(kEnd);
  return path.substr(0, has_end ? path.size() - kEnd.size() : path.size()) + ".golden.csv";
}

}  // namespace eagerx::train
