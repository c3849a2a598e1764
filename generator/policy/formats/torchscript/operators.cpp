// torch's operators over tensors.
#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "generator/policy/formats/torchscript/value.hpp"

namespace eagerx::gen {
namespace {

using Torch = TorchCall;
using Result = std::optional<NetValue>;

Result with_factor(const Torch& call, const char* type) {
  const auto a = call.tensor(0);
  auto b = call.tensor(1, "other");
  const auto factor = call.number(2, "alpha", 1.0);
  if (!a || !b || !factor || (a->is_condition && b->is_condition)) return std::nullopt;
  if (*factor != 1.0) {
    b = call.node("Mul", {*b, call.constant({static_cast<float>(*factor)}, {})});
  }
  return call.node(type, {*a, *b});
}
Result add(const Torch& call) {
  return with_factor(call, "Add");
}
Result subtract(const Torch& call) {
  return with_factor(call, "Sub");
}
Result subtract_from(const Torch& call) {  // rsub(a, b): b - a
  const auto a = call.tensor(0);
  const auto b = call.tensor(1, "other");
  if (!a || !b || call.number(2, "alpha", 1.0) != 1.0) return std::nullopt;
  return call.node("Sub", {*b, *a});
}
Result divide(const Torch& call) {
  if (!call.argument(2, "rounding_mode").is_none()) return std::nullopt;
  return torch_of_two("Div")(call);
}
/// Of two tensors: `max` and `min` are other things with one, and with an axis.
Result maximum(const Torch& call) {
  return call.argument(1, "other").is_tensor() ? torch_of_two("Max")(call) : std::nullopt;
}
Result minimum(const Torch& call) {
  return call.argument(1, "other").is_tensor() ? torch_of_two("Min")(call) : std::nullopt;
}
Result reciprocal(const Torch& call) {
  const auto x = call.tensor(0);
  return x ? Result(call.node("Div", {call.constant({1.0F}, {}), *x})) : std::nullopt;
}
Result inverse_root(const Torch& call) {
  const auto x = call.tensor(0);
  if (!x) return std::nullopt;
  return call.node("Div", {call.constant({1.0F}, {}), call.node("Sqrt", {*x})});
}
Result power(const Torch& call) {
  const auto x = call.tensor(0);
  const auto exponent = call.name() == "square" ? 2.0 : call.number(1, "exponent", std::nullopt);
  if (!x || !exponent) return std::nullopt;
  if (*exponent == 0.5) return call.node("Sqrt", {*x});
  return call.node("Pow", {*x, call.constant({static_cast<float>(*exponent)}, {})});
}

NetValue turned(const Torch& call, const NetValue& matrix) {
  return call.node("Transpose", {matrix}, {{"perm", {}, {}, Integers{1, 0}}});
}
Result linear(const Torch& call) {
  const auto x = call.tensor(0);
  const auto weight = call.tensor(1, "weight");
  if (!x || !weight || torch_rank(*weight) != 2) return std::nullopt;
  const auto bias = call.tensor(2, "bias");
  if (bias && torch_rank(*x) == 2) {
    return call.node("Gemm", {*x, *weight, *bias}, {{"transB", 1}});
  }
  const NetValue product = call.node("MatMul", {*x, turned(call, *weight)});
  if (call.argument(2, "bias").is_none()) return product;
  return bias ? Result(call.node("Add", {product, *bias})) : std::nullopt;
}
Result silu(const Torch& call) {
  const auto x = call.tensor(0);
  return x ? Result(call.node("Mul", {*x, call.node("Sigmoid", {*x})})) : std::nullopt;
}
Result gelu(const Torch& call) {
  const auto x = call.tensor(0);
  const TorchValue& how = call.argument(1, "approximate");
  const bool by_tanh = how.text == "tanh";
  if (!x || (!how.is_none() && how.text != "none" && !by_tanh)) return std::nullopt;
  return call.node("Gelu", {*x}, {{"approximate", {}, {}, {}, by_tanh ? "tanh" : "none"}});
}
Result clamped(const Torch& call, const TorchValue& low, const TorchValue& high) {
  const auto x = call.tensor(0);
  if (!x) return std::nullopt;
  NetValue value = *x;
  for (const auto& [bound, type] : {std::pair{&low, "Max"}, std::pair{&high, "Min"}}) {
    if (bound->is_none()) continue;
    const auto number = bound->number();
    if (!number && !bound->is_tensor()) return std::nullopt;
    if (number == 0.0 && bound == &low) {
      value = call.node("Relu", {value});
    } else {
      value = call.node(type, {value, number ? call.constant({static_cast<float>(*number)}, {})
                                             : bound->tensor->value});
    }
  }
  return value;
}
Result clamp(const Torch& call) {
  return clamped(call, call.argument(1, "min"), call.argument(2, "max"));
}
Result clamp_min(const Torch& call) {
  return clamped(call, call.argument(1, "min"), TorchValue());
}
Result clamp_max(const Torch& call) {
  return clamped(call, TorchValue(), call.argument(1, "max"));
}
Result hard_tanh(const Torch& call) {
  const auto low = call.number(1, "min_val", -1.0);
  const auto high = call.number(2, "max_val", 1.0);
  if (!low || !high) return std::nullopt;
  return clamped(call, TorchValue::of(*low), TorchValue::of(*high));
}
Result relu6(const Torch& call) {
  return clamped(call, TorchValue::of(0.0), TorchValue::of(6.0));
}

Result layer_norm(const Torch& call) {
  const auto x = call.tensor(0);
  const auto shape = call.list(1, "normalized_shape");
  const auto epsilon = call.number(4, "eps", 1e-5);
  if (!x || !x->shape || !shape || shape->size() != 1 || !epsilon) return std::nullopt;
  if (x->shape->empty() || x->shape->back() != shape->front()) return std::nullopt;
  const auto ones = [&] {
    return call.constant(std::vector<float>(static_cast<std::size_t>(shape->front()), 1.0F),
                         *shape);
  };
  const auto gamma = call.tensor(2, "weight");
  const auto beta = call.tensor(3, "bias");
  std::vector<NetValue> inputs = {*x, gamma ? *gamma : ones()};
  if (beta) inputs.push_back(*beta);
  return call.node("LayerNormalization", inputs, {{"axis", -1}, {"epsilon", {}, epsilon}});
}
Result reduce(const Torch& call, const char* type, std::size_t first) {
  const auto x = call.tensor(0);
  auto axes = call.list(first, "dim");
  const auto keeps = call.whole(first + 1, "keepdim", 0);
  if (!x || !x->shape || !axes || !keeps) return std::nullopt;
  return call.node(type, {*x}, {{"axes", {}, {}, axes}, {"keepdims", keeps}});
}
Result mean(const Torch& call) {
  return reduce(call, "ReduceMean", 1);
}
Result norm(const Torch& call) {
  if (call.number(1, "p", 2.0) != 2.0) return std::nullopt;
  return reduce(call, "ReduceL2", 2);
}

Result cat(const Torch& call) {
  std::vector<NetValue> parts;
  for (const TorchValue& item : call.argument(0).items) {
    if (!item.is_tensor()) return std::nullopt;
    parts.push_back(item.tensor->value);
  }
  const auto axis = call.whole(1, "dim", 0);
  if (parts.empty() || !axis) return std::nullopt;
  return call.node("Concat", parts, {{"axis", axis}});
}

/// Of a size that is said, or of that of another value.
Result zeros(const Torch& call) {
  const bool is_like = call.name().ends_with("_like");
  const auto like = is_like ? call.tensor(0) : std::nullopt;
  const auto shape = is_like ? (like ? like->shape : std::nullopt) : call.list(0, "size");
  const std::int64_t count =
      shape ? element_count(*shape).value_or(kMaxValues + 1) : kMaxValues + 1;
  if (count > kMaxValues || !call.state().spend(count)) {
    return std::nullopt;
  }
  const float value = call.name().starts_with("ones") ? 1.0F : 0.0F;
  return call.constant(std::vector<float>(static_cast<std::size_t>(count), value), *shape);
}
Result number(const Torch& call) {
  return call.tensor(0);
}

}  // namespace

std::vector<TorchRow> torch_plain_rows() {
  using As = TorchGiven::As;
  return {
      {"relu", torch_of("Relu")},
      {"tanh", torch_of("Tanh")},
      {"sigmoid", torch_of("Sigmoid")},
      {"selu", torch_of("Selu")},
      {"sin", torch_of("Sin")},
      {"cos", torch_of("Cos")},
      {"exp", torch_of("Exp")},
      {"abs", torch_of("Abs")},
      {"sqrt", torch_of("Sqrt")},
      {"round", torch_of("Round")},
      {"floor", torch_of("Floor")},
      {"ceil", torch_of("Ceil")},
      {"neg", torch_of("Neg")},
      {"add", add},
      {"sub", subtract},
      {"rsub", subtract_from},
      {"mul", torch_of_two("Mul")},
      {"div", divide},
      {"maximum", maximum},
      {"max", maximum},
      {"min", minimum},
      {"minimum", minimum},
      {"reciprocal", reciprocal},
      {"rsqrt", inverse_root},
      {"pow", power},
      {"square", power},
      {"linear", linear},
      // addmm(b, x, w): beta b + alpha x w
      {"addmm", torch_of("Gemm", {{1}, {2}, {0}},
                         {{As::number, "alpha", {4, "alpha"}, 1.0},
                          {As::number, "beta", {3, "beta"}, 1.0}})},
      {"matmul", torch_of_two("MatMul")},
      {"mm", torch_of_two("MatMul")},
      {"elu", torch_of("Elu", {{0}},
                       {{As::number, "alpha", {1, "alpha"}, 1.0},
                        {As::number, "", {2, "scale"}, 1.0},
                        {As::number, "", {3, "input_scale"}, 1.0}})},
      {"leaky_relu",
       torch_of("LeakyRelu", {{0}}, {{As::number, "alpha", {1, "negative_slope"}, 0.01}})},
      {"silu", silu},
      {"gelu", gelu},
      {"mish", torch_of("Mish")},
      {"softplus",
       torch_of("Softplus", {{0}},
                {{As::number, "", {1, "beta"}, 1.0}, {As::number, "", {2, "threshold"}, 20.0}})},
      {"softmax", torch_of("Softmax", {{0}}, {{As::whole, "axis", {1, "dim"}}})},
      {"argmax",
       torch_of("ArgMax", {{0}},
                {{As::whole, "axis", {1, "dim"}}, {As::whole, "keepdims", {2, "keepdim"}, 0.0}})},
      {"clamp", clamp},
      {"clip", clamp},
      {"clamp_min", clamp_min},
      {"clamp_max", clamp_max},
      {"hardtanh", hard_tanh},
      {"relu6", relu6},
      {"layer_norm", layer_norm},
      // batch_norm(x, weight, bias, mean, var, training, momentum, eps)
      {"batch_norm", torch_of("BatchNormalization", {{0}, {1}, {2}, {3}, {4}},
                              {{As::whole, "", {5, "training"}, 0.0},
                               {As::number, "epsilon", {7, "eps"}, 1e-5}})},
      {"mean", mean},
      {"norm", norm},
      {"linalg_vector_norm", norm},
      {"cat", cat},
      {"concat", cat},
      {"zeros", zeros},
      {"ones", zeros},
      {"zeros_like", zeros},
      {"ones_like", zeros},
      {"tensor", number}};
}

const TorchRow* torch_row(std::string_view name) {
  static const auto kTable = [] {
    std::map<std::string_view, TorchRow> table;
    for (const auto& part :
         {torch_plain_rows(), torch_shape_rows(), torch_image_rows(), torch_condition_rows()}) {
      for (const TorchRow& row : part) table.emplace(row.name, row);
    }
    return table;
  }();
  const auto found = kTable.find(name);
  return found == kTable.end() ? nullptr : &found->second;
}

std::optional<TorchValue> run_torch_operator(const TorchCall& call, PolicyProblem& problem) {
  const std::string_view name = call.name();
  if (name == "lstm" || name == "gru") return torch_recurrence(call, problem);
  if (name == "split" || name == "split_with_sizes" || name == "chunk") {
    auto parts = torch_parts(call);
    if (!parts) problem = call.misused("with sizes that are not those of the value");
    return parts;
  }
  const TorchRow* row = torch_row(name);
  if (row == nullptr) {
    return refuse(
        problem, "E0754",
        fmt::format("calls `{}`, which is not supported ({})", printable(name), call.where()),
        "export the actor alone, or export it to ONNX with `torch.onnx.export`");
  }
  auto value = row->run(call);
  if (value) return TorchValue::of(std::move(*value));
  problem = call.misused("in a way that is not supported");
  return std::nullopt;
}

}  // namespace eagerx::gen
