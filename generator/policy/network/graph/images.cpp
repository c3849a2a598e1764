// Operators over images and sequences: [1, channels, height, width] or [1, channels, width].
#include <fmt/core.h>

#include <array>
#include <utility>

#include "generator/policy/network/graph/operators.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

using Kind = NetValue::Kind;

constexpr std::int64_t kMaxSide = std::int64_t{1} << 16U;

/// Attribute `name` with a value for each axis; `otherwise` for all if it is not there.
std::optional<Integers> per_axis(const NetCall& call, std::string_view name, std::size_t axes,
                                 std::int64_t otherwise, std::int64_t lowest) {
  const NetAttribute* found = call.attribute(name);
  Integers values = found != nullptr ? found->integers() : Integers(axes, otherwise);
  if (values.size() != axes) return std::nullopt;
  for (const std::int64_t value : values) {
    if (value < lowest || value > kMaxSide) return std::nullopt;
  }
  return values;
}

/// One axis of a kernel.
struct Axis {
  std::int64_t size = 1, kernel = 1, stride = 1, dilation = 1, before = 0, after = 0;
  [[nodiscard]] std::int64_t results() const {
    const std::int64_t room = size + before + after - dilation * (kernel - 1) - 1;
    return room < 0 ? 0 : room / stride + 1;
  }
};

/// How a kernel is moved; and why it cannot be.
struct Geometry {
  KernelShape kernel;
  Dims result;  // [1, channels, places…], channels as read
  std::string problem;
};

Geometry geometry_of(const NetCall& call, const Dims& dims, const Integers& kernel,
                     const NetPad* pad) {
  Geometry geometry;
  const std::size_t axes = dims.size() - 2;
  const auto strides = per_axis(call, "strides", axes, 1, 1);
  const auto dilations = per_axis(call, "dilations", axes, 1, 1);
  const auto pads = per_axis(call, "pads", 2 * axes, 0, 0);
  const std::string_view automatic = call.text("auto_pad");
  const bool plain = automatic.empty() || automatic == "NOTSET" || automatic == "VALID";
  if (!strides || !dilations || !pads || !plain || call.integer("ceil_mode", 0) != 0) {
    geometry.problem = plain ? "with strides, dilations, pads or a ceil_mode that are not supported"
                             : "with automatic padding";
    return geometry;
  }
  std::array<Axis, 2> axis;  // down, right
  for (std::size_t i = 0; i < axes; ++i) {
    Axis& one = axis[2 - axes + i];
    one = {dims[2 + i], kernel[i], (*strides)[i], (*dilations)[i], (*pads)[i], (*pads)[axes + i]};
  }
  if (pad != nullptr) {
    axis[0].before += pad->top;
    axis[0].after += pad->bottom;
    axis[1].before += pad->left;
    axis[1].after += pad->right;
  }
  geometry.result = {1, dims[1]};
  for (std::size_t i = 0; i < 2; ++i) {
    const Axis& one = axis[i];
    if (one.size > kMaxSide || one.kernel < 1 || one.kernel > kMaxSide || one.results() < 1 ||
        one.results() > kMaxSide) {
      geometry.problem = "whose kernel does not fit";
      return geometry;
    }
    if (i >= 2 - axes) geometry.result.push_back(one.results());
  }
  const auto small = [](std::int64_t value) { return static_cast<std::uint32_t>(value); };
  geometry.kernel = {small(dims[1]),          small(axis[0].size),     small(axis[1].size),
                     small(axis[0].kernel),   small(axis[1].kernel),   small(axis[0].stride),
                     small(axis[1].stride),   small(axis[0].before),   small(axis[1].before),
                     small(axis[0].dilation), small(axis[1].dilation), small(axis[0].results()),
                     small(axis[1].results())};
  return geometry;
}

bool is_image(const NetValue& x) {
  return x.kind == Kind::data && x.shape && (x.shape->size() == 3 || x.shape->size() == 4) &&
         x.shape->front() == 1 && (*x.shape)[1] <= kMaxValues;
}

/// Zeros that are put around `x`, and what is before them.
struct Padded {
  const NetPad* pad = nullptr;
  std::int32_t before = -1;
  Dims dims;
};

Padded padded(const NetCall& call, const NetValue& x) {
  Padded result{nullptr, x.step, *x.shape};
  const NetStep* step = call.step_of(x);
  result.pad = step != nullptr ? std::get_if<NetPad>(&step->what) : nullptr;
  if (result.pad == nullptr) return result;
  result.before = step->before;
  const std::size_t rank = result.dims.size();
  result.dims[rank - 1] -= std::int64_t{result.pad->left} + result.pad->right;
  if (rank == 4) result.dims[2] -= std::int64_t{result.pad->top} + result.pad->bottom;
  return result;
}

NetValue convolution(const NetCall& call) {
  const NetValue& x = call.input(0);
  const NetValue& w = call.input(1);
  const NetValue& b = call.input(2);
  if (!is_image(x) || w.kind != Kind::constant || w.constant.transposed ||
      w.constant.dims.size() != x.shape->size()) {
    return call.misused("that is not of an image and constant weights");
  }
  const Dims& weights = w.constant.dims;
  const Padded from = padded(call, x);
  const std::int64_t groups = call.integer("group", 1);
  const std::int64_t channels = weights[0];
  if (groups < 1 || groups > from.dims[1] || from.dims[1] % groups != 0 || channels < 1 ||
      channels > kMaxSide || channels % groups != 0 || weights[1] != from.dims[1] / groups) {
    return call.other(
        {"E0618",
         fmt::format("moves weights `{}` of shape {} over {} channels in {}",
                     printable(w.constant.tensor->name), show(weights), from.dims[1], call.who()),
         kExportMisfit});
  }
  Geometry geometry = geometry_of(call, from.dims, {weights.begin() + 2, weights.end()}, from.pad);
  if (!geometry.problem.empty()) return call.misused(geometry.problem);
  geometry.result[1] = channels;
  NetLayer work{Convolution{geometry.kernel, static_cast<std::uint32_t>(groups),
                            static_cast<std::uint32_t>(channels)},
                w.constant};
  if (b.kind != Kind::absent) {
    if (b.kind != Kind::constant || b.constant.dims != Dims{channels}) {
      return call.misused("with a bias that does not fit", geometry.result);
    }
    work.bias = b.constant;
  }
  return call.data_after(from.before, std::move(work), std::move(geometry.result));
}

/// Whether there is a value under the kernel at every place.
bool reaches_all(const KernelShape& kernel) {
  const auto meets = [](std::int64_t size, std::int64_t count, std::int64_t step,
                        std::int64_t reach, std::int64_t before, std::int64_t places) {
    for (std::int64_t place = 0; place < places; ++place) {
      bool found = false;
      for (std::int64_t k = 0; k < count && !found; ++k) {
        const std::int64_t at = place * step + k * reach - before;
        found = at >= 0 && at < size;
      }
      if (!found) return false;
    }
    return true;
  };
  return meets(kernel.height, kernel.rows, kernel.stride_down, kernel.dilation_down, kernel.pad_top,
               kernel.out_height) &&
         meets(kernel.width, kernel.columns, kernel.stride_right, kernel.dilation_right,
               kernel.pad_left, kernel.out_width);
}

NetValue pool(const NetCall& call, Pooling::Kind kind, bool global) {
  const NetValue& x = call.input(0);
  if (!is_image(x)) return call.misused("that is not of an image", x.shape);
  const Padded from = padded(call, x);
  if (from.pad != nullptr && (kind == Pooling::Kind::max || global)) {
    return call.misused("behind padding", x.shape);
  }
  Integers kernel(from.dims.begin() + 2, from.dims.end());
  if (!global) {
    const auto given = per_axis(call, "kernel_shape", kernel.size(), 0, 1);
    if (!given) return call.misused("without the shape of its kernel");
    kernel = *given;
  }
  const bool counts = call.integer("count_include_pad", 0) != 0;
  if (kind == Pooling::Kind::average && (counts || from.pad != nullptr)) {
    const NetAttribute* pads = call.attribute("pads");
    const auto pads_more = [](std::int64_t side) { return side != 0; };
    if (!counts && pads != nullptr && ranges::any_of(pads->integers(), pads_more)) {
      return call.misused("with two kinds of padding");
    }
    kind = Pooling::Kind::average_with_padding;
  }
  Geometry geometry = geometry_of(call, from.dims, kernel, from.pad);
  if (!geometry.problem.empty()) return call.misused(geometry.problem);
  const KernelShape& moved = geometry.kernel;
  if (!call.spend(std::int64_t{moved.rows} * moved.out_height +
                  std::int64_t{moved.columns} * moved.out_width)) {
    return call.too_much();
  }
  if (!reaches_all(moved)) {
    return call.misused("with a kernel that lies in the padding alone");
  }
  return call.layer_after(from.before, Pooling{geometry.kernel, kind}, std::move(geometry.result));
}

template <Pooling::Kind Which, bool IsGlobal>
NetValue pools(const NetCall& call) {
  return pool(call, Which, IsGlobal);
}

/// The mean along one axis of [outer, n, inner], as a pool over that axis.
NetValue mean_along(const NetCall& call, std::int64_t axis) {
  const NetValue& x = call.input(0);
  const Dims& dims = *x.shape;
  const auto product = [](const Dims& some) {
    return static_cast<std::uint32_t>(element_count(some).value_or(0));
  };
  Pooling work;
  work.kind = Pooling::Kind::average;
  work.kernel.channels = product(Dims(dims.begin(), dims.begin() + axis));
  work.kernel.height = work.kernel.rows = product({dims[static_cast<std::size_t>(axis)]});
  work.kernel.width = product(Dims(dims.begin() + axis + 1, dims.end()));
  work.kernel.out_width = work.kernel.width;
  Dims shape = dims;
  shape[static_cast<std::size_t>(axis)] = 1;
  if (call.integer("keepdims", 1) == 0) shape.erase(shape.begin() + axis);
  return call.layer_after(x.step, work, shape);
}

/// A part of LayerNorm, the mean of each channel, or one along an axis: of quantiles.
NetValue reduce_mean(const NetCall& call) {
  const NetValue& x = call.input(0);
  auto axes = call.integers(1, "axes");
  if (x.kind == Kind::data && axes && axes->size() == 1) {
    const auto axis = place_in(axes->front(), rank_of(x));
    if (!axis) return call.misused("with axes that are not there");
    if (rank_of(x) != 3 || *axis != 2) return mean_along(call, *axis);
  }
  if (!is_image(x) || !axes || axes->size() + 2 != x.shape->size()) {
    return call.misused("that is neither of a LayerNorm nor of an image", x.shape);
  }
  const auto rank = static_cast<std::int64_t>(x.shape->size());
  std::int64_t sum = 0;
  for (const std::int64_t axis : *axes) {
    const auto place = place_in(axis, rank);
    if (!place) return call.misused("with axes that are not there");
    sum += *place;
  }
  if (sum != (rank == 4 ? 5 : 2)) return call.misused("over other axes than an image's");
  NetValue value = pool(call, Pooling::Kind::average, true);
  if (value.kind != Kind::data || call.integer("keepdims", 1) != 0) return value;
  value.shape = Dims{1, (*x.shape)[1]};
  return value;
}

/// Zeros around an image; elsewhere only none.
NetValue pad(const NetCall& call) {
  const NetValue& x = call.input(0);
  const auto pads = call.integers(1, "pads");
  const NetAttribute* mode = call.attribute("mode");
  const bool constant = mode == nullptr || mode->text == "constant";
  const NetValue& filling = call.input(2);
  const bool zeros = (filling.kind == Kind::absent || scalar_of(filling) == 0.0F) &&
                     call.real("value", 0.0F) == 0.0F;  // an attribute before opset 11
  if (x.kind != Kind::data || !pads || pads->size() != 2 * x.shape->size() || !constant || !zeros ||
      call.input(3).kind != Kind::absent) {
    return call.misused("other than with zeros", x.shape);
  }
  const std::size_t rank = x.shape->size();
  Dims shape = *x.shape;
  bool inside = true;
  std::int64_t total = 0;
  for (std::size_t i = 0; i < rank; ++i) {
    const std::int64_t before = (*pads)[i];
    const std::int64_t after = (*pads)[rank + i];
    if (before < 0 || after < 0 || before > kMaxSide || after > kMaxSide) {
      return call.misused("by an impossible number", x.shape);
    }
    inside = inside && (i >= 2 || before + after == 0);
    total += before + after;
    shape[i] += before + after;
  }
  if (total == 0) return x;
  if (!is_image(x) || !inside) return call.misused("of something else than an image", x.shape);
  const auto side = [&](std::size_t i) { return static_cast<std::uint32_t>((*pads)[i]); };
  NetPad work{0, side(rank - 1), 0, side(2 * rank - 1)};
  if (rank == 4) {
    work.top = side(2);
    work.bottom = side(rank + 2);
  }
  return call.data_after(x.step, work, std::move(shape));
}

}  // namespace

std::vector<NetOperator> image_operators() {
  using P = Pooling::Kind;
  return {{"Conv", convolution, time_of_image, {.has_weights = true}},
          {"MaxPool", pools<P::max, false>, time_of_image},
          {"AveragePool", pools<P::average, false>, time_of_image},
          {"GlobalMaxPool", pools<P::max, true>, time_of_image},
          {"GlobalAveragePool", pools<P::average, true>, time_of_image},
          {"ReduceMean", reduce_mean, time_of_reduce, {.formula = NetFormula::mean}},
          {"Pad", pad, time_of_image}};
}

}  // namespace eagerx::gen
