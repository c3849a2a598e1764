// Operators that compute: dense layers and activations.
#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "generator/policy/network/graph/operators.hpp"

namespace eagerx::gen {
bool fits_as_bias(const NetValue& bias, const Dims& result, std::int64_t outputs) {
  const std::int64_t count = element_count(bias.constant.dims).value_or(0);
  const std::optional<Dims> sum = broadcast(result, bias.constant.dims);
  return !bias.constant.transposed && (count == 1 || count == outputs) && sum &&
         element_count(*sum) == outputs;
}

namespace {

using Kind = NetValue::Kind;

NetConstant swapped(NetConstant constant) {
  std::swap(constant.dims[0], constant.dims[1]);
  constant.transposed = !constant.transposed;
  return constant;
}

/// A constant times data of `length` values: `weights` [outputs, inputs] and the result's shape.
NetValue product(const NetCall& call, const NetValue& data, NetLayer dense, Dims result) {
  const Dims& dims = dense.weights->dims;
  const std::int64_t length = element_count(*data.shape).value_or(0);
  if (dims[1] != length || dims[0] < 1 || length < 1) {
    if (call.state().lacks == 0) call.state().lacks = dims[1] - length;
    return call.other(
        {"E0618",
         fmt::format("multiplies {} values by tensor `{}`, which takes {}, in {}", length,
                     printable(dense.weights->tensor->name), dims[1], call.who()),
         kExportMisfit});
  }
  return call.data_after(data.step, std::move(dense), std::move(result));
}

Reorder turned(std::int64_t rows, std::int64_t columns) {
  Reorder order;
  for (std::int64_t column = 0; column < columns; ++column) {
    for (std::int64_t row = 0; row < rows; ++row) {
      order.from.push_back(static_cast<std::uint32_t>(row * columns + column));
    }
  }
  return order;
}

/// Several rows of values [..., R, K] times one matrix, as the steps of a history go through an
/// encoder: a convolution whose kernel is one place wide over [K, R], and its result turned back.
NetValue product_of_rows(const NetCall& call, const NetValue& data, const NetLayer& dense) {
  constexpr std::int64_t kMostRows = std::int64_t{1} << 16U;
  const std::int64_t length = data.shape->back();
  const std::int64_t outputs = dense.weights->dims[0];
  const std::int64_t rows =
      element_count(*data.shape).value_or(0) / std::max<std::int64_t>(length, 1);
  if (dense.weights->dims[1] != length || outputs < 1 || length < 1 || rows > kMostRows ||
      dense.scale != 1.0F || dense.bias_scale != 1.0F ||
      (dense.bias && element_count(dense.bias->dims) != outputs)) {
    return call.misused(fmt::format("on shapes {} and {}, which do not fit", show(*data.shape),
                                    show(dense.weights->dims)));
  }
  const std::int64_t most = std::max(length, outputs);
  if (most > kMaxValues / rows || !call.spend(rows * (length + outputs))) return call.too_much();
  NetValue columns = reordered(call, data, turned(rows, length), {1, length, rows});
  if (columns.kind != Kind::data) return columns;
  KernelShape kernel;
  kernel.channels = static_cast<std::uint32_t>(length);
  kernel.width = kernel.out_width = static_cast<std::uint32_t>(rows);
  NetLayer work{Convolution{kernel, 1, static_cast<std::uint32_t>(outputs)}, dense.weights,
                dense.bias};
  NetValue made = call.data_after(columns.step, std::move(work), {1, outputs, rows});
  if (made.kind != Kind::data) return made;
  Dims result = *data.shape;
  result.back() = outputs;
  return reordered(call, made, turned(outputs, rows), std::move(result));
}

/// [1, K] (or [K, 1] where `transposed`): the shape of one observation as a row.
bool is_row(const Dims& dims, bool transposed) {
  return dims.size() == 2 && dims[transposed ? 1 : 0] == 1;
}

NetValue gemm(const NetCall& call) {
  const NetValue& a = call.input(0);
  const NetValue& b = call.input(1);
  const NetValue& c = call.input(2);
  const bool trans_a = call.integer("transA", 0) != 0;
  const bool trans_b = call.integer("transB", 0) != 0;
  const auto operands = operands_of(call);
  if (!operands) return call.misused("without exactly one constant matrix");
  const auto& [data, matrix, data_left] = *operands;
  // y = x B is W = B^T; y = A x is W = A.
  const bool transposed = data_left ? !trans_b : trans_a;
  const bool has_rows = data_left && !trans_a && data.shape->size() == 2 &&
                        matrix.constant.dims.size() == 2 && data.shape->front() > 1;
  if (matrix.constant.dims.size() != 2 ||
      (!has_rows && !is_row(*data.shape, data_left ? trans_a : !trans_b))) {
    return call.misused(fmt::format("on shapes {} and {}, not a matrix and one row of values",
                                    show(*a.shape), show(*b.shape)));
  }
  NetLayer dense;
  dense.weights = transposed ? swapped(matrix.constant) : matrix.constant;
  dense.scale = call.real("alpha", 1.0F);
  const std::int64_t outputs = dense.weights->dims[0];
  Dims result = data_left ? Dims{data.shape->front(), outputs} : Dims{outputs, 1};
  if (c.kind != Kind::absent) {
    if (c.kind != Kind::constant) return call.misused("with a bias that is not constant", result);
    if (!fits_as_bias(c, has_rows ? Dims{outputs} : result, outputs)) {
      return call.other({"E0618",
                         fmt::format("adds bias `{}` of shape {} to {} values in {}",
                                     printable(c.constant.tensor->name), show(c.constant.dims),
                                     outputs, call.who()),
                         kExportMisfit});
    }
    dense.bias = c.constant;
    dense.bias_scale = call.real("beta", 1.0F);  // not of a bias that a later Add brings
  }
  if (has_rows) return product_of_rows(call, data, dense);
  return product(call, data, std::move(dense), std::move(result));
}

NetValue matmul(const NetCall& call) {
  const NetValue& a = call.input(0);
  const NetValue& b = call.input(1);
  const auto operands = operands_of(call);
  if (!operands) return call.misused("without exactly one constant matrix");
  const auto& [data, constant, data_left] = *operands;
  const NetConstant& matrix = constant.constant;
  Dims result = *data.shape;
  // Left [..., 1, K] or [K]; right [K, 1] or [K]: one vector, not a batch of them.
  const std::size_t along = data_left ? result.size() - 1 : 0;
  const bool vector = !result.empty() && element_count(result) == result[along];
  const bool has_rows = data_left && result.size() > 1;
  if (matrix.dims.size() != 2 || (!vector && !has_rows) || (!data_left && result.size() > 2)) {
    return call.misused(fmt::format("on shapes {} and {}, not a matrix and one row of values",
                                    show(*a.shape), show(*b.shape)));
  }
  NetLayer dense;
  dense.weights = data_left ? swapped(matrix) : matrix;
  if (!vector) return product_of_rows(call, data, dense);
  result[along] = dense.weights->dims[0];
  return product(call, data, std::move(dense), std::move(result));
}

NetValue activation(const NetCall& call, Activation kind, float slope = 0.0F) {
  const NetValue& x = call.input(0);
  if (x.kind != Kind::data) return call.misused("on a constant", x.shape);
  return call.data_after(x.step, NetActivation{kind, slope}, *x.shape);
}

/// elu with an alpha of 1, the only one that celu shares with it.
NetValue celu(const NetCall& call) {
  if (call.real("alpha", 1.0F) != 1.0F) return call.misused("whose alpha is not 1");
  return activation(call, Activation::elu, 1.0F);
}
/// With one slope for all values.
NetValue parametric_relu(const NetCall& call) {
  const auto slope = scalar_of(call.input(1));
  if (!slope) return call.misused("with more than one slope", call.input(0).shape);
  return activation(call, Activation::leaky_relu, *slope);
}

NetValue elu(const NetCall& call) {
  return activation(call, Activation::elu, call.real("alpha", 1.0F));
}
NetValue leaky_relu(const NetCall& call) {
  return activation(call, Activation::leaky_relu, call.real("alpha", 0.01F));
}
template <Activation Which>
NetValue plain(const NetCall& call) {
  return activation(call, Which);
}

/// x tanh(softplus(x)). Opset 18 on; exporters of older ones write it so.
NetValue mish(const NetCall& call) {
  const NetValue& x = call.input(0);
  if (x.kind != Kind::data) return call.misused("on a constant", x.shape);
  NetValue gate = call.data_after(x.step, NetActivation{Activation::softplus}, *x.shape);
  gate = call.data_after(gate.step, NetActivation{Activation::tanh}, *x.shape);
  return call.data_of({x, gate}, Combination::Operation::product, *x.shape);
}

/// Opset 20 on.
NetValue gelu(const NetCall& call) {
  const NetAttribute* how = call.attribute("approximate");
  const bool by_tanh = how != nullptr && how->text == "tanh";
  return activation(call, by_tanh ? Activation::gelu_tanh : Activation::gelu);
}

/// Over the last axis, which is the only one longer than 1.
NetValue layer_normalization(const NetCall& call) {
  const NetValue& x = call.input(0);
  const NetValue& gamma = call.input(1);
  const NetValue& beta = call.input(2);
  if (x.kind != Kind::data || gamma.kind != Kind::constant || x.shape->empty()) {
    return call.misused("without a constant scale", x.shape);
  }
  const std::int64_t axis = call.integer("axis", -1);
  const auto last = static_cast<std::int64_t>(x.shape->size()) - 1;
  const std::int64_t count = element_count(*x.shape).value_or(0);
  const bool whole = (axis == -1 || axis == last) && x.shape->back() == count;
  const bool fits = gamma.constant.dims == Dims{count} &&
                    (beta.kind == Kind::absent ||
                     (beta.kind == Kind::constant && beta.constant.dims == Dims{count}));
  if (!whole || !fits) return call.misused("that does not take all values of a layer", x.shape);
  NetNorm norm{std::optional(gamma.constant), std::nullopt, call.real("epsilon", 1e-5F)};
  if (beta.kind == Kind::constant) norm.beta = beta.constant;
  return call.data_after(x.step, std::move(norm), *x.shape);
}

NetValue dropout(const NetCall& call) {
  const auto training = integers_of(call.input(2));
  const bool given = call.input(2).kind != Kind::absent;
  if (given && (!training || training->empty() || training->front() != 0)) {
    return call.misused("in training mode", call.input(0).shape);
  }
  return call.input(0);
}

std::optional<TimeMask> time_of_matmul(const NetCall& call, const NetValue& /*result*/) {
  const NetValue& a = call.input(0);
  if (a.kind == Kind::data) return time_unless(a, rank_of(a) - 1);
  const NetValue& b = call.input(1);
  return time_unless(b, std::max(rank_of(b) - 2, std::int64_t{0}));
}
std::optional<TimeMask> time_of_gemm(const NetCall& call, const NetValue& /*result*/) {
  const bool left = call.input(0).kind == Kind::data;
  const NetValue& data = call.input(left ? 0 : 1);
  const bool transposed = call.integer(left ? "transA" : "transB", 0) != 0;
  const std::int64_t summed = left != transposed ? 1 : 0;
  if (has_time(data.time, summed)) return std::nullopt;
  return has_time(data.time, 1 - summed) ? time_bit(left ? 0 : 1) : 0U;
}

}  // namespace

std::vector<NetOperator> layer_operators() {
  return {{"Gemm", gemm, time_of_gemm, {.has_weights = true}},
          {"MatMul", matmul, time_of_matmul, {.has_weights = true}},
          {"Relu", plain<Activation::relu>, time_of_each},
          {"Tanh", plain<Activation::tanh>, time_of_each, {.formula = NetFormula::tanh}},
          {"Elu", elu, time_of_each, {.keeps_shape = true}},
          {"Celu", celu, time_of_each},
          {"PRelu", parametric_relu, time_of_each},
          {"LeakyRelu", leaky_relu, time_of_each, {.keeps_shape = true}},
          {"Sigmoid", plain<Activation::sigmoid>, time_of_each, {.keeps_shape = true}},
          {"Softplus", plain<Activation::softplus>, time_of_each, {.keeps_shape = true}},
          {"Gelu", gelu, time_of_each},
          {"Mish", mish, time_of_each},
          {"LayerNormalization", layer_normalization, time_but_last},
          {"Dropout", dropout, time_of_each}};
}

}  // namespace eagerx::gen
