#include "generator/policy/formats/actor/parts.hpp"

#include <fmt/core.h>

#include <array>
#include <cmath>

#include "generator/policy/network/limits.hpp"

namespace eagerx::gen {
namespace {

/// The finite numbers of tensor `name`, as many as `count`. E0618 and those of `floats_of`.
std::optional<std::vector<float>> numbers(const ActorParts& parts, const std::string& name,
                                          std::uint32_t count) {
  const StoredTensor* tensor = parts.table.find(name);
  if (tensor == nullptr || tensor->shape != Dims{std::int64_t{count}}) {
    return refuse(parts.problem, "E0618",
                  tensor == nullptr
                      ? fmt::format("has a layer without tensor `{}`", printable(name))
                      : fmt::format("has tensor `{}` of shape {} for {} values", printable(name),
                                    show(tensor->shape), count),
                  kOtherActor);
  }
  parts.used.insert(name);
  return floats_of(name, *tensor, parts.problem);
}

/// `layer` with the numbers of `base`, and a relu behind it. E0618 and those of `floats_of`.
bool add_weights(const ActorParts& parts, const std::string& base, const StoredTensor& weight,
                 Layer layer) {
  const std::string name = base + ".weight";
  auto weights = floats_of(name, weight, parts.problem);
  const auto outputs = static_cast<std::uint32_t>(weight.shape[0]);
  auto bias = weights ? numbers(parts, base + ".bias", outputs) : std::nullopt;
  if (!bias) return false;
  parts.used.insert(name);
  layer.activation = Activation::relu;
  layer.weights = std::move(*weights);
  layer.bias = std::move(*bias);
  parts.network.layers.push_back(std::move(layer));
  return true;
}

void add_elementwise(Network& network, std::uint32_t count, Elementwise::Operation operation,
                     std::vector<float> values) {
  network.layers.push_back(layer_of(Elementwise{operation}, count, count, std::move(values)));
}

bool is_image_size(const Dims& image) {
  constexpr std::int64_t kLargest = 4096;
  return image.size() == 3 && std::all_of(image.begin(), image.end(), [](std::int64_t size) {
           return size >= 1 && size <= kLargest;
         });
}

/// E0619 for images and results that no robot keeps, and that 32 bits may not count.
bool has_room(const ActorParts& parts, const std::string& name, std::int64_t channels,
              std::int64_t places, std::int64_t products = 1) {
  if (channels <= kMaxValues / places && products <= kMaxProducts / (channels * places)) {
    return true;
  }
  return parts.fail("E0619",
                    fmt::format("has more than {} values or {} products at `{}`", kMaxValues,
                                kMaxProducts, printable(name)),
                    "use smaller images, or a smaller network");
}

/// One convolution of NatureCNN; `shape` [channels, rows, columns] becomes that of its result.
bool add_convolution(const ActorParts& parts, const std::string& base, std::uint32_t size,
                     std::uint32_t stride, std::array<std::uint32_t, 3>& shape) {
  const std::string name = base + ".weight";
  const StoredTensor* weight = parts.table.find(name);
  const bool fits = weight != nullptr && weight->shape.size() == 4 && weight->shape[0] >= 1 &&
                    weight->shape[2] == size && weight->shape[3] == size;
  if (!fits) {
    return parts.fail(
        "E0628",
        fmt::format("has a features extractor other than NatureCNN: `{}` {}", printable(name),
                    weight == nullptr ? "is missing" : show(weight->shape)),
        "export the actor to ONNX");
  }
  const auto [channels, height, width] = shape;
  if (weight->shape[1] != channels || height < size || width < size) {
    return parts.fail(
        "E0618",
        fmt::format("takes images of {} channels with at least {}x{} values in `{}`, but is given "
                    "[{}, {}, {}]",
                    weight->shape[1], size, size, printable(name), channels, height, width),
        "images of a NatureCNN are channels first, and at least 36x36");
  }
  Convolution form;
  form.channels = static_cast<std::uint32_t>(weight->shape[0]);
  form.kernel.channels = channels;
  form.kernel.height = height;
  form.kernel.width = width;
  form.kernel.rows = form.kernel.columns = size;
  form.kernel.stride_down = form.kernel.stride_right = stride;
  form.kernel.out_height = (height - size) / stride + 1;
  form.kernel.out_width = (width - size) / stride + 1;
  const std::int64_t places =
      std::int64_t{form.kernel.out_height} * std::int64_t{form.kernel.out_width};
  if (!has_room(parts, name, weight->shape[0], places, std::int64_t{channels} * size * size)) {
    return false;
  }
  shape = {form.channels, form.kernel.out_height, form.kernel.out_width};
  return add_weights(
      parts, base, *weight,
      layer_of(form, channels * height * width, form.channels * form.kernel.places()));
}

}  // namespace

bool add_nature_cnn(const ActorParts& parts, const std::string& prefix) {
  if (!parts.facts.image || !is_image_size(*parts.facts.image)) {
    return parts.fail("E0628",
                      fmt::format("takes images (`{}cnn`), but does not say how large they are",
                                  printable(prefix)),
                      "give Stable-Baselines3's zip, or export the actor to ONNX");
  }
  std::array<std::uint32_t, 3> shape{};
  for (std::size_t i = 0; i < shape.size(); ++i) {
    shape[i] = static_cast<std::uint32_t>((*parts.facts.image)[i]);
  }
  if (!has_room(parts, prefix + "cnn", shape[0], std::int64_t{shape[1]} * std::int64_t{shape[2]})) {
    return false;
  }
  Network& network = parts.network;
  network.input_shape.assign(shape.begin(), shape.end());
  struct Kernel {
    const char* name;
    std::uint32_t size, stride;
  };
  for (const Kernel& kernel :
       {Kernel{"cnn.0", 8, 4}, Kernel{"cnn.2", 4, 2}, Kernel{"cnn.4", 3, 1}}) {
    if (!add_convolution(parts, prefix + kernel.name, kernel.size, kernel.stride, shape)) {
      return false;
    }
  }
  const std::string name = prefix + "linear.0.weight";
  const StoredTensor* weight = parts.table.find(name);
  const std::int64_t inputs = network.outputs();
  if (weight == nullptr || weight->shape.size() != 2 || weight->shape[0] < 1 ||
      weight->shape[1] != inputs) {
    return parts.fail(
        "E0618",
        fmt::format("has {} values behind its convolutions, but `{}` {}", inputs, printable(name),
                    weight == nullptr ? "is missing" : "is " + show(weight->shape)));
  }
  return add_weights(parts, prefix + "linear.0", *weight,
                     layer_of(Dense{}, static_cast<std::uint32_t>(inputs),
                              static_cast<std::uint32_t>(weight->shape[0])));
}

bool is_batch_norm(const TensorTable& table, const std::string& base) {
  return table.find(base + ".ra_mean") != nullptr || table.find(base + ".running_mean") != nullptr;
}

bool add_batch_norm(const ActorParts& parts, const std::string& base) {
  constexpr double kNormEpsilon = 1e-5;  // torch's default
  const bool renorm = parts.table.find(base + ".ra_mean") != nullptr;
  const StoredTensor* first = parts.table.find(base + (renorm ? ".ra_mean" : ".running_mean"));
  Network& network = parts.network;
  const std::int64_t size = first->shape.size() == 1 ? first->shape[0] : 0;
  const std::int64_t count = network.layers.empty() ? size : std::int64_t{network.outputs()};
  if (count < 1 || count > std::int64_t{UINT32_MAX}) {
    return parts.fail("E0618", fmt::format("has a batch norm `{}` of shape {}", printable(base),
                                           show(first->shape)));
  }
  const auto values = static_cast<std::uint32_t>(count);
  const std::string scale_name = base + (renorm ? ".scale" : ".weight");
  auto mean = numbers(parts, base + (renorm ? ".ra_mean" : ".running_mean"), values);
  auto variance =
      mean ? numbers(parts, base + (renorm ? ".ra_var" : ".running_var"), values) : std::nullopt;
  if (!variance) return false;
  std::optional<std::vector<float>> scale = std::vector<float>(values, 1.0F);
  std::optional<std::vector<float>> bias = std::vector<float>(values, 0.0F);
  if (parts.table.find(scale_name) != nullptr) scale = numbers(parts, scale_name, values);
  if (scale && parts.table.find(base + ".bias") != nullptr) {
    bias = numbers(parts, base + ".bias", values);
  }
  if (!scale || !bias) return false;
  for (std::size_t i = 0; i < scale->size(); ++i) {
    const double sum =
        static_cast<double>((*variance)[i]) + (renorm ? parts.facts.norm_epsilon : kNormEpsilon);
    if (!(sum > 0.0)) {
      return parts.fail(
          "E0616", fmt::format("has a variance below zero in batch norm `{}`", printable(base)));
    }
    (*scale)[i] = static_cast<float>(static_cast<double>((*scale)[i]) / std::sqrt(sum));
  }
  add_elementwise(network, values, Elementwise::Operation::subtract, std::move(*mean));
  add_elementwise(network, values, Elementwise::Operation::multiply, std::move(*scale));
  add_elementwise(network, values, Elementwise::Operation::add, std::move(*bias));
  for (const char* name : {".steps", ".num_batches_tracked"}) parts.used.insert(base + name);
  return true;
}

bool average_quantiles(const ActorParts& parts) {
  Layer& layer = parts.network.layers.back();
  const std::int64_t actions = parts.facts.actions.value_or(0);
  if (actions < 1) {
    return parts.fail("E0628", "gives quantiles, but does not say for how many actions",
                      "give Stable-Baselines3's zip, or export the actor to ONNX");
  }
  if (!layer.is_dense() || layer.norm || layer.outputs % actions != 0) {
    return parts.fail("E0626", fmt::format("says that it has {} actions, but gives {} quantiles",
                                           actions, layer.outputs));
  }
  const auto count = static_cast<std::size_t>(actions);
  const std::size_t quantiles = layer.outputs / count;
  const auto mean = [&](const std::vector<float>& values, std::size_t width) {
    std::vector<float> result(count * width);
    for (std::size_t i = 0; i < result.size(); ++i) {
      double sum = 0.0;
      for (std::size_t k = 0; k < quantiles; ++k) {
        sum += static_cast<double>(values[k * result.size() + i]);
      }
      result[i] = static_cast<float>(sum / static_cast<double>(quantiles));
    }
    return result;
  };
  layer.weights = mean(layer.weights, layer.inputs);
  layer.bias = mean(layer.bias, 1);
  layer.outputs = static_cast<std::uint32_t>(count);
  return true;
}

void add_limits(Network& network, float limit) {
  using Operation = Elementwise::Operation;
  const std::uint32_t count = network.outputs();
  add_elementwise(network, count, Operation::at_least, {-limit});
  add_elementwise(network, count, Operation::at_most, {limit});
}

}  // namespace eagerx::gen
