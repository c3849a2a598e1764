// QuantizeLinear and DequantizeLinear: integers of a few bits that represent real numbers. Weights
// are converted to real numbers; between layers, the network rounds as an ONNX runtime does.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <eagerx/math/rounding.hpp>
#include <limits>
#include <utility>

#include "generator/policy/network/graph/operators.hpp"

namespace eagerx::gen {
namespace {

using Kind = NetValue::Kind;
using Operation = Elementwise::Operation;

/// The numbers that a type holds.
struct WholeNumbers {
  float low, high;
};

template <class T>
WholeNumbers range() {
  using Limits = std::numeric_limits<T>;
  return {static_cast<float>(Limits::min()), static_cast<float>(Limits::max())};
}

std::optional<WholeNumbers> range_of(ElementType type) {
  switch (type) {
    case ElementType::int8:
      return range<std::int8_t>();
    case ElementType::uint8:
      return range<std::uint8_t>();
    case ElementType::int16:
      return range<std::int16_t>();
    default:
      return std::nullopt;
  }
}

/// Real numbers are (q - zero) * scale, with one scale and zero, or one for each index of `axis`.
struct Grid {
  std::vector<float> scales{}, zeros{};
  std::size_t axis = 0;
};

/// Inputs 1 and 2 of both operators; without a zero point it is 0.
std::optional<Grid> grid_of(const NetCall& call, const Dims& shape) {
  const NetValue& scale = call.input(1);
  const NetValue& zero = call.input(2);
  PolicyProblem ignored;
  const bool known = scale.kind == Kind::constant &&
                     (zero.kind == Kind::absent || zero.kind == Kind::constant) &&
                     call.integer("block_size", 0) == 0;
  if (!known || scale.constant.dims.size() > 1) return std::nullopt;
  if (!call.spend(2 * element_count(scale.constant.dims).value_or(0))) return std::nullopt;
  const auto scales = read_floats(scale.constant, ignored);
  if (!scales || scales->empty()) return std::nullopt;
  Grid grid{*scales, std::vector<float>(scales->size(), 0.0F)};
  if (scales->size() > 1) {
    const auto axis = call.axis(shape.size(), 1);
    if (!axis || shape[*axis] != static_cast<std::int64_t>(scales->size())) return std::nullopt;
    grid.axis = *axis;
  }
  if (zero.kind == Kind::absent) return grid;
  if (is_real(zero.constant.tensor->type) || zero.constant.dims != scale.constant.dims)
    return std::nullopt;
  const std::vector<double> zeros = read_numbers(zero.constant);
  std::transform(zeros.begin(), zeros.end(), grid.zeros.begin(),
                 [](double number) { return static_cast<float>(number); });
  return grid;
}

NetValue without_grid(const NetCall& call) {
  return call.misused("whose scale and zero point are not constants of one or one per channel",
                      call.input(0).shape);
}

/// `work(number, scale, zero)` of each number of a constant.
template <class Work>
NetValue each_of(const NetCall& call, const Grid& grid, const Work& work) {
  const NetConstant& x = call.input(0).constant;
  if (!call.spend(4 * element_count(x.dims).value_or(kMaxElements))) return call.too_much();
  const std::vector<double> numbers = read_numbers(x);
  std::int64_t inner = 1;
  for (std::size_t axis = grid.axis + 1; axis < x.dims.size(); ++axis) inner *= x.dims[axis];
  std::vector<float> results(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::size_t channel =
        grid.scales.size() == 1 ? 0 : i / static_cast<std::size_t>(inner) % grid.scales.size();
    results[i] = work(numbers[i], grid.scales[channel], grid.zeros[channel]);
  }
  return made_constant(call, results, x.dims);
}

/// x op c for each number of the observation's.
NetValue step(const NetCall& call, const NetValue& x, Operation operation, float number) {
  const auto value = elementwise_step(call, x, operation, made_constant(call, number));
  return value ? *value : call.misused("on an unknown shape", x.shape);
}

/// The type of the result: the zero point's, else what an attribute says, else uint8.
std::optional<WholeNumbers> result_range(const NetCall& call) {
  const NetValue& zero = call.input(2);
  if (zero.kind == Kind::constant) return range_of(zero.constant.tensor->type);
  const std::int64_t said = call.integer("output_dtype", 0);
  const auto type = said == 0 ? std::optional(ElementType::uint8) : onnx_type(said);
  return type ? range_of(*type) : std::nullopt;
}

/// saturate(round(x / scale) + zero), halves to even.
NetValue quantize(const NetCall& call) {
  const NetValue& x = call.input(0);
  const auto range = result_range(call);
  if (!range) return call.misused("to a type other than int8, uint8 and int16", x.shape);
  if (!x.shape) return call.misused("on an unknown shape");
  const auto grid = grid_of(call, *x.shape);
  if (!grid) return without_grid(call);
  if (x.kind == Kind::constant) {
    return each_of(call, *grid, [&range](double number, float scale, float zero) {
      const float whole = round_to_even(static_cast<float>(number) / scale) + zero;
      return std::clamp(whole, range->low, range->high);
    });
  }
  if (x.kind != Kind::data || grid->scales.size() > 1) {
    return call.misused("with several scales of what is not a constant", x.shape);
  }
  NetValue value = step(call, x, Operation::divide, grid->scales[0]);
  if (value.kind != Kind::data) return value;
  value = call.layer_after(value.step, Function{Function::Kind::round_to_even}, *x.shape);
  if (grid->zeros[0] != 0.0F) value = step(call, value, Operation::add, grid->zeros[0]);
  value = step(call, value, Operation::at_least, range->low);
  return value.kind == Kind::data ? step(call, value, Operation::at_most, range->high) : value;
}

/// (x - zero) * scale.
NetValue dequantize(const NetCall& call) {
  const NetValue& x = call.input(0);
  if (!x.shape) return call.misused("on an unknown shape");
  const auto grid = grid_of(call, *x.shape);
  if (!grid) return without_grid(call);
  if (x.kind == Kind::constant) {
    return each_of(call, *grid, [](double number, float scale, float zero) {
      return static_cast<float>(number - static_cast<double>(zero)) * scale;
    });
  }
  if (x.kind != Kind::data || grid->scales.size() > 1) {
    return call.misused("with several scales of what is not a constant", x.shape);
  }
  NetValue value = x;
  if (grid->zeros[0] != 0.0F) value = step(call, value, Operation::subtract, grid->zeros[0]);
  return value.kind == Kind::data ? step(call, value, Operation::multiply, grid->scales[0]) : value;
}

}  // namespace

std::vector<NetOperator> quantized_operators() {
  return {{"QuantizeLinear", quantize, time_of_each, {.keeps_shape = true}},
          {"DequantizeLinear", dequantize, time_of_each, {.keeps_shape = true}}};
}

}  // namespace eagerx::gen
