// torch's convolutions, pools and padding.
#include <algorithm>
#include <utility>

#include "generator/policy/formats/torchscript/value.hpp"

namespace eagerx::gen {
namespace {

using Torch = TorchCall;
using Result = std::optional<NetValue>;

/// How many axes an image or a sequence of numbers has besides batch and channels.
std::size_t places_of(const NetValue& x) {
  const auto rank = static_cast<std::size_t>(torch_rank(x));
  return rank == 3 || rank == 4 ? rank - 2 : 0;
}

/// One number for each of those axes; an empty list is `otherwise`.
std::optional<Integers> for_each(const Torch& call, std::size_t i, std::string_view name,
                                 std::size_t axes, const Integers& otherwise) {
  if (call.argument(i, name).is_none()) return otherwise;
  auto values = call.list(i, name);
  if (!values) return std::nullopt;
  if (values->empty()) return otherwise;
  if (values->size() == 1) values->resize(axes, values->front());
  return values->size() == axes ? values : std::nullopt;
}

/// As ONNX has them: those before all axes, then those behind.
Integers on_both_sides(const Integers& padding) {
  Integers pads = padding;
  pads.insert(pads.end(), padding.begin(), padding.end());
  return pads;
}

/// Where the arguments of a convolution are.
struct Places {
  std::size_t dilation, groups;
};

Result convolved(const Torch& call, const Places& at) {
  const auto x = call.tensor(0);
  const auto weight = call.tensor(1, "weight");
  const std::size_t axes = x ? places_of(*x) : 0;
  if (axes == 0 || !weight) return std::nullopt;
  const TorchValue& how = call.argument(4, "padding");
  const bool is_valid = how.kind == TorchValue::Kind::text && how.text == "valid";
  const Integers none(axes, 0);
  const auto strides = for_each(call, 3, "stride", axes, Integers(axes, 1));
  const auto padding = is_valid ? std::optional(none) : for_each(call, 4, "padding", axes, none);
  const auto dilations = for_each(call, at.dilation, "dilation", axes, Integers(axes, 1));
  const auto groups = call.whole(at.groups, "groups", 1);
  if (!strides || !padding || !dilations || !groups) return std::nullopt;
  std::vector<NetValue> inputs = {*x, *weight};
  if (!call.argument(2, "bias").is_none()) {
    const auto bias = call.tensor(2, "bias");
    if (!bias) return std::nullopt;
    inputs.push_back(*bias);
  }
  return call.node("Conv", inputs,
                   {{"strides", {}, {}, strides},
                    {"pads", {}, {}, on_both_sides(*padding)},
                    {"dilations", {}, {}, dilations},
                    {"group", groups}});
}
Result convolution(const Torch& call) {
  return convolved(call, {5, 6});
}
/// Arguments that tracing writes: x, weight, bias, stride, padding, dilation, transposed,
/// output_padding, groups, and switches of the machine.
Result traced_convolution(const Torch& call) {
  if (call.whole(6, "transposed", 0) != 0) return std::nullopt;
  return convolved(call, {5, 8});
}

/// Parameters of pools: a window of `kernel` numbers that moves by `strides`.
struct Windows {
  NetValue x;
  std::size_t axes = 0;
  Integers kernel, strides, padding;
};

std::optional<Windows> windows_of(const Torch& call) {
  const auto x = call.tensor(0);
  const std::size_t axes = x ? places_of(*x) : 0;
  const auto kernel = for_each(call, 1, "kernel_size", axes, {});
  if (axes == 0 || !kernel || kernel->size() != axes) return std::nullopt;
  const auto strides = for_each(call, 2, "stride", axes, *kernel);
  const auto padding = for_each(call, 3, "padding", axes, Integers(axes, 0));
  if (!strides || !padding) return std::nullopt;
  return Windows{*x, axes, *kernel, *strides, *padding};
}

Result max_pool(const Torch& call) {
  const auto windows = windows_of(call);
  if (!windows) return std::nullopt;
  const auto dilations = for_each(call, 4, "dilation", windows->axes, Integers(windows->axes, 1));
  const auto rounds_up = call.whole(5, "ceil_mode", 0);
  if (!dilations || !rounds_up) return std::nullopt;
  return call.node("MaxPool", {windows->x},
                   {{"kernel_shape", {}, {}, windows->kernel},
                    {"strides", {}, {}, windows->strides},
                    {"pads", {}, {}, on_both_sides(windows->padding)},
                    {"dilations", {}, {}, dilations},
                    {"ceil_mode", rounds_up}});
}

Result average_pool(const Torch& call) {
  const auto windows = windows_of(call);
  const auto rounds_up = call.whole(4, "ceil_mode", 0);
  const auto counts = call.whole(5, "count_include_pad", 1);
  const bool usual = call.argument(6, "divisor_override").is_none();
  if (!windows || !rounds_up || !counts || !usual) return std::nullopt;
  return call.node("AveragePool", {windows->x},
                   {{"kernel_shape", {}, {}, windows->kernel},
                    {"strides", {}, {}, windows->strides},
                    {"pads", {}, {}, on_both_sides(windows->padding)},
                    {"ceil_mode", rounds_up},
                    {"count_include_pad", counts}});
}

/// To a size that divides that of the image: windows side by side.
Result adaptive_pool(const Torch& call, const char* type) {
  const auto x = call.tensor(0);
  const std::size_t axes = x ? places_of(*x) : 0;
  const auto sizes = for_each(call, 1, "output_size", axes, {});
  if (axes == 0 || !sizes || sizes->size() != axes) return std::nullopt;
  Integers kernel;
  for (std::size_t i = 0; i < axes; ++i) {
    const std::int64_t size = (*x->shape)[2 + i];
    if ((*sizes)[i] < 1 || size % (*sizes)[i] != 0) return std::nullopt;
    kernel.push_back(size / (*sizes)[i]);
  }
  return call.node(type, {*x}, {{"kernel_shape", {}, {}, kernel}, {"strides", {}, {}, kernel}});
}
Result adaptive_average_pool(const Torch& call) {
  return adaptive_pool(call, "AveragePool");
}

/// torch counts the last axis first: before it, behind it, before the one in front of it, …
Result pad(const Torch& call) {
  const auto x = call.tensor(0);
  const auto pads = call.list(1, "pad");
  const TorchValue& mode = call.argument(2, "mode");
  const bool has_mode = call.name() == "pad";
  const auto filling = call.number(has_mode ? 3 : 2, "value", 0.0);
  const bool usual = !has_mode || mode.is_none() || mode.text == "constant";
  if (!x || !x->shape || !pads || !usual || filling != 0.0 || pads->size() % 2 != 0 ||
      pads->size() / 2 > x->shape->size()) {
    return std::nullopt;
  }
  const std::size_t rank = x->shape->size();
  Integers sides(2 * rank, 0);
  for (std::size_t i = 0; i < pads->size() / 2; ++i) {
    sides[rank - 1 - i] = (*pads)[2 * i];
    sides[2 * rank - 1 - i] = (*pads)[2 * i + 1];
  }
  // Opset 17 has them as an input.
  return call.node("Pad", {*x, integers_value(sides)});
}

}  // namespace

std::vector<TorchRow> torch_image_rows() {
  return {{"conv1d", convolution},
          {"conv2d", convolution},
          {"_convolution", traced_convolution},
          {"max_pool1d", max_pool},
          {"max_pool2d", max_pool},
          {"avg_pool1d", average_pool},
          {"avg_pool2d", average_pool},
          {"adaptive_avg_pool1d", adaptive_average_pool},
          {"adaptive_avg_pool2d", adaptive_average_pool},
          {"pad", pad},
          {"constant_pad_nd", pad}};
}

}  // namespace eagerx::gen
