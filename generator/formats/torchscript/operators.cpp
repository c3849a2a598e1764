// torch's operators over tensors.
#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "generator/formats/torchscript/value.hpp"

namespace eagerx::gen {
namespace {

using Torch = TorchCall;
using Result = std::optional<OnnxValue>;
using Operator = Result (*)(const Torch& call);

/// With one input, as ONNX has it.
template <const char* (*Name)()>
Result same(const Torch& call) {
  const auto x = call.tensor(0);
  return x ? Result(call.node(Name(), {*x})) : std::nullopt;
}
#define EAGERX_SAME(function, type) \
  const char* function##_name() {   \
    return type;                    \
  }

EAGERX_SAME(relu, "Relu")
EAGERX_SAME(tanh, "Tanh")
EAGERX_SAME(sigmoid, "Sigmoid")
EAGERX_SAME(selu, "Selu")
EAGERX_SAME(sin, "Sin")
EAGERX_SAME(cos, "Cos")
EAGERX_SAME(exp, "Exp")
EAGERX_SAME(abs, "Abs")
EAGERX_SAME(sqrt, "Sqrt")
EAGERX_SAME(neg, "Neg")
#undef EAGERX_SAME

std::int64_t rank_of(const OnnxValue& x) {
  return static_cast<std::int64_t>(x.shape ? x.shape->size() : 0);
}
/// An axis, counted from the front.
std::optional<std::int64_t> axis_of(const OnnxValue& x, std::optional<std::int64_t> axis) {
  if (!axis || !x.shape) return std::nullopt;
  const std::int64_t place = *axis < 0 ? *axis + rank_of(x) : *axis;
  return place >= 0 && place < rank_of(x) ? std::optional(place) : std::nullopt;
}

Result with_factor(const Torch& call, const char* type) {
  const auto a = call.tensor(0);
  auto b = call.tensor(1, "other");
  const auto factor = call.number(2, "alpha", 1.0);
  if (!a || !b || !factor) return std::nullopt;
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
Result pair(const Torch& call, const char* type) {
  const auto a = call.tensor(0);
  const auto b = call.tensor(1, "other");
  return a && b ? Result(call.node(type, {*a, *b})) : std::nullopt;
}
Result multiply(const Torch& call) {
  return pair(call, "Mul");
}
Result divide(const Torch& call) {
  if (!call.argument(2, "rounding_mode").is_none()) return std::nullopt;
  return pair(call, "Div");
}
Result maximum(const Torch& call) {
  return pair(call, "Max");
}
Result minimum(const Torch& call) {
  return pair(call, "Min");
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

OnnxValue turned(const Torch& call, const OnnxValue& matrix) {
  return call.node("Transpose", {matrix}, {{"perm", {}, {}, Integers{1, 0}}});
}
Result linear(const Torch& call) {
  const auto x = call.tensor(0);
  const auto weight = call.tensor(1, "weight");
  if (!x || !weight || rank_of(*weight) != 2) return std::nullopt;
  const OnnxValue product = call.node("MatMul", {*x, turned(call, *weight)});
  if (call.argument(2, "bias").is_none()) return product;
  const auto bias = call.tensor(2, "bias");
  return bias ? Result(call.node("Add", {product, *bias})) : std::nullopt;
}
Result addmm(const Torch& call) {  // addmm(b, x, w): beta b + alpha x w
  const auto bias = call.tensor(0);
  const auto x = call.tensor(1);
  const auto weight = call.tensor(2);
  const auto beta = call.number(3, "beta", 1.0);
  const auto alpha = call.number(4, "alpha", 1.0);
  if (!bias || !x || !weight || !beta || !alpha) return std::nullopt;
  return call.node("Gemm", {*x, *weight, *bias}, {{"alpha", {}, alpha}, {"beta", {}, beta}});
}
Result matmul(const Torch& call) {
  return pair(call, "MatMul");
}

Result elu(const Torch& call) {
  const auto x = call.tensor(0);
  const auto alpha = call.number(1, "alpha", 1.0);
  const bool usual =
      call.number(2, "scale", 1.0) == 1.0 && call.number(3, "input_scale", 1.0) == 1.0;
  if (!x || !alpha || !usual) return std::nullopt;
  return call.node("Elu", {*x}, {{"alpha", {}, alpha}});
}
Result leaky_relu(const Torch& call) {
  const auto x = call.tensor(0);
  const auto slope = call.number(1, "negative_slope", 0.01);
  return x && slope ? Result(call.node("LeakyRelu", {*x}, {{"alpha", {}, slope}})) : std::nullopt;
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
Result softplus(const Torch& call) {
  const auto x = call.tensor(0);
  const bool usual =
      call.number(1, "beta", 1.0) == 1.0 && call.number(2, "threshold", 20.0) == 20.0;
  return x && usual ? Result(call.node("Softplus", {*x})) : std::nullopt;
}
Result softmax(const Torch& call) {
  const auto x = call.tensor(0);
  const auto axis = call.whole(1, "dim", std::nullopt);
  return x && axis ? Result(call.node("Softmax", {*x}, {{"axis", axis}})) : std::nullopt;
}
Result arg_max(const Torch& call) {
  const auto x = call.tensor(0);
  const auto axis = call.whole(1, "dim", std::nullopt);
  const auto keeps = call.whole(2, "keepdim", 0);
  if (!x || !axis || !keeps) return std::nullopt;
  return call.node("ArgMax", {*x}, {{"axis", axis}, {"keepdims", keeps}});
}

Result clamped(const Torch& call, const TorchValue& low, const TorchValue& high) {
  const auto x = call.tensor(0);
  if (!x) return std::nullopt;
  OnnxValue value = *x;
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
  std::vector<OnnxValue> inputs = {*x, gamma ? *gamma : ones()};
  if (beta) inputs.push_back(*beta);
  return call.node("LayerNormalization", inputs, {{"axis", -1}, {"epsilon", {}, epsilon}});
}
Result batch_norm(const Torch& call) {  // x, weight, bias, mean, var, training, momentum, eps
  const auto x = call.tensor(0);
  const auto gamma = call.tensor(1);
  const auto beta = call.tensor(2);
  const auto mean = call.tensor(3);
  const auto variance = call.tensor(4);
  const auto epsilon = call.number(7, "eps", 1e-5);
  if (!x || !gamma || !beta || !mean || !variance || !epsilon ||
      call.whole(5, "training", 0) != 0) {
    return std::nullopt;
  }
  return call.node("BatchNormalization", {*x, *gamma, *beta, *mean, *variance},
                   {{"epsilon", {}, epsilon}});
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
  std::vector<OnnxValue> parts;
  for (const TorchValue& item : call.argument(0).items) {
    if (!item.is_tensor()) return std::nullopt;
    parts.push_back(item.tensor->value);
  }
  const auto axis = call.whole(1, "dim", 0);
  if (parts.empty() || !axis) return std::nullopt;
  return call.node("Concat", parts, {{"axis", axis}});
}

Result transpose(const Torch& call) {
  const auto x = call.tensor(0);
  if (!x || !x->shape) return std::nullopt;
  Integers order(x->shape->size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<std::int64_t>(i);
  const bool matrix = call.name() == "t" || call.name() == "numpy_T";
  const auto a = matrix ? axis_of(*x, 0) : axis_of(*x, call.whole(1, "dim0", std::nullopt));
  const auto b = matrix ? axis_of(*x, -1) : axis_of(*x, call.whole(2, "dim1", std::nullopt));
  if (!a || !b || (matrix && order.size() > 2)) return std::nullopt;
  std::swap(order[static_cast<std::size_t>(*a)], order[static_cast<std::size_t>(*b)]);
  return call.node("Transpose", {*x}, {{"perm", {}, {}, order}});
}
Result permute(const Torch& call) {
  const auto x = call.tensor(0);
  auto order = call.list(1, "dims");
  if (!x || !order) return std::nullopt;
  for (std::int64_t& axis : *order) axis = axis < 0 ? axis + rank_of(*x) : axis;
  return call.node("Transpose", {*x}, {{"perm", {}, {}, order}});
}
Result reshape(const Torch& call) {
  const auto x = call.tensor(0);
  const auto shape = call.list(1, "shape");
  if (!x || !shape) return std::nullopt;
  return call.node("Reshape", {*x}, {{"shape", {}, {}, shape}, {"allowzero", 1}});
}
Result flatten(const Torch& call) {
  const auto x = call.tensor(0);
  const auto first = x ? axis_of(*x, call.whole(1, "start_dim", 0)) : std::nullopt;
  const auto last = x ? axis_of(*x, call.whole(2, "end_dim", -1)) : std::nullopt;
  if (!first || !last || *last < *first) return std::nullopt;
  Integers shape;
  for (std::int64_t i = 0; i < rank_of(*x); ++i) {
    const std::int64_t size = (*x->shape)[static_cast<std::size_t>(i)];
    if (i > *first && i <= *last) {
      shape.back() *= size;
    } else {
      shape.push_back(size);
    }
  }
  return call.node("Reshape", {*x}, {{"shape", {}, {}, shape}});
}
Result unsqueeze(const Torch& call) {
  const auto x = call.tensor(0);
  const auto axis = call.list(1, "dim");
  return x && axis ? Result(call.node("Unsqueeze", {*x}, {{"axes", {}, {}, axis}})) : std::nullopt;
}
Result squeeze(const Torch& call) {
  const auto x = call.tensor(0);
  if (!x) return std::nullopt;
  if (call.argument(1, "dim").is_none()) return call.node("Squeeze", {*x});
  const auto axis = axis_of(*x, call.whole(1, "dim", std::nullopt));
  if (!axis) return std::nullopt;
  if ((*x->shape)[static_cast<std::size_t>(*axis)] != 1) return x;
  return call.node("Squeeze", {*x}, {{"axes", {}, {}, Integers{*axis}}});
}
Result expand(const Torch& call) {
  const auto x = call.tensor(0);
  std::optional<Integers> shape;
  if (call.name() == "expand_as") {
    const auto other = call.tensor(1, "other");
    if (other && other->shape) shape = *other->shape;
  } else {
    shape = call.list(1, "size");
  }
  if (!x || !x->shape || !shape || shape->size() < x->shape->size()) return std::nullopt;
  const std::size_t more = shape->size() - x->shape->size();
  for (std::size_t i = more; i < shape->size(); ++i) {
    if ((*shape)[i] == -1) (*shape)[i] = (*x->shape)[i - more];
  }
  return call.node("Expand", {*x}, {{"shape", {}, {}, shape}});
}

OnnxValue part(const Torch& call, const OnnxValue& x, std::int64_t axis, std::int64_t first,
               std::int64_t last, std::int64_t step = 1) {
  return call.node("Slice", {x},
                   {{"starts", {}, {}, Integers{first}},
                    {"ends", {}, {}, Integers{last}},
                    {"axes", {}, {}, Integers{axis}},
                    {"steps", {}, {}, Integers{step}}});
}
Result slice(const Torch& call) {
  const auto x = call.tensor(0);
  const auto axis = x ? axis_of(*x, call.whole(1, "dim", 0)) : std::nullopt;
  const auto first = call.whole(2, "start", 0);
  const auto last = call.whole(3, "end", std::numeric_limits<std::int64_t>::max());
  const auto step = call.whole(4, "step", 1);
  if (!axis || !first || !last || !step) return std::nullopt;
  return part(call, *x, *axis, *first, *last, *step);
}
Result narrow(const Torch& call) {
  const auto x = call.tensor(0);
  const auto axis = x ? axis_of(*x, call.whole(1, "dim", std::nullopt)) : std::nullopt;
  const auto first = call.whole(2, "start", std::nullopt);
  const auto count = call.whole(3, "length", std::nullopt);
  const std::int64_t size = axis ? (*x->shape)[static_cast<std::size_t>(*axis)] : 0;
  if (!axis || !first || !count || *first < 0 || *count < 1 || *first > size - *count) {
    return std::nullopt;
  }
  return part(call, *x, *axis, *first, *first + *count);
}
Result select(const Torch& call) {
  const auto x = call.tensor(0);
  const auto axis = x ? axis_of(*x, call.whole(1, "dim", std::nullopt)) : std::nullopt;
  const auto index = call.whole(2, "index", std::nullopt);
  if (!axis || !index) return std::nullopt;
  return call.node("Gather", {*x, integers_value({*index}, {})}, {{"axis", axis}});
}
Result zeros(const Torch& call) {
  const auto shape = call.list(0, "size");
  const std::int64_t count =
      shape ? element_count(*shape).value_or(kMaxValues + 1) : kMaxValues + 1;
  if (count > kMaxValues || !OnnxCall(onnx::NodeProto(), {}, call.state()).spend(count)) {
    return std::nullopt;
  }
  const float value = call.name() == "ones" ? 1.0F : 0.0F;
  return call.constant(std::vector<float>(static_cast<std::size_t>(count), value), *shape);
}
Result number(const Torch& call) {
  return call.tensor(0);
}

const std::map<std::string_view, Operator>& operators() {
  static const std::map<std::string_view, Operator> kTable = {{"relu", same<relu_name>},
                                                              {"tanh", same<tanh_name>},
                                                              {"sigmoid", same<sigmoid_name>},
                                                              {"selu", same<selu_name>},
                                                              {"sin", same<sin_name>},
                                                              {"cos", same<cos_name>},
                                                              {"exp", same<exp_name>},
                                                              {"abs", same<abs_name>},
                                                              {"sqrt", same<sqrt_name>},
                                                              {"neg", same<neg_name>},
                                                              {"add", add},
                                                              {"sub", subtract},
                                                              {"rsub", subtract_from},
                                                              {"mul", multiply},
                                                              {"div", divide},
                                                              {"maximum", maximum},
                                                              {"minimum", minimum},
                                                              {"reciprocal", reciprocal},
                                                              {"rsqrt", inverse_root},
                                                              {"pow", power},
                                                              {"square", power},
                                                              {"linear", linear},
                                                              {"addmm", addmm},
                                                              {"matmul", matmul},
                                                              {"mm", matmul},
                                                              {"elu", elu},
                                                              {"leaky_relu", leaky_relu},
                                                              {"silu", silu},
                                                              {"gelu", gelu},
                                                              {"softplus", softplus},
                                                              {"softmax", softmax},
                                                              {"argmax", arg_max},
                                                              {"clamp", clamp},
                                                              {"clip", clamp},
                                                              {"clamp_min", clamp_min},
                                                              {"clamp_max", clamp_max},
                                                              {"hardtanh", hard_tanh},
                                                              {"relu6", relu6},
                                                              {"layer_norm", layer_norm},
                                                              {"batch_norm", batch_norm},
                                                              {"mean", mean},
                                                              {"norm", norm},
                                                              {"linalg_vector_norm", norm},
                                                              {"cat", cat},
                                                              {"concat", cat},
                                                              {"t", transpose},
                                                              {"numpy_T", transpose},
                                                              {"transpose", transpose},
                                                              {"permute", permute},
                                                              {"reshape", reshape},
                                                              {"view", reshape},
                                                              {"flatten", flatten},
                                                              {"unsqueeze", unsqueeze},
                                                              {"squeeze", squeeze},
                                                              {"expand", expand},
                                                              {"expand_as", expand},
                                                              {"slice", slice},
                                                              {"narrow", narrow},
                                                              {"select", select},
                                                              {"zeros", zeros},
                                                              {"ones", zeros},
                                                              {"tensor", number}};
  return kTable;
}

/// Neighbouring parts along an axis, as a list.
std::optional<TorchValue> parts_of(const Torch& call) {
  const auto x = call.tensor(0);
  const auto axis = x ? axis_of(*x, call.whole(2, "dim", 0)) : std::nullopt;
  auto sizes = call.list(1);
  if (!axis || !sizes || sizes->empty()) return std::nullopt;
  const std::int64_t size = (*x->shape)[static_cast<std::size_t>(*axis)];
  if (call.argument(1).kind == TorchValue::Kind::integer) {
    std::int64_t each = sizes->front();
    if (each < 1) return std::nullopt;
    if (call.name() == "chunk") each = (size + each - 1) / each;
    sizes->clear();
    constexpr std::int64_t kMostParts = 1024;
    if (size > each * kMostParts) return std::nullopt;
    for (std::int64_t first = 0; first < size; first += each) {
      sizes->push_back(std::min(each, size - first));
    }
  }
  std::vector<TorchValue> parts;
  std::int64_t first = 0;
  for (const std::int64_t count : *sizes) {
    if (count < 1 || count > size - first) return std::nullopt;
    parts.push_back(TorchValue::of(part(call, *x, *axis, first, first + count)));
    first += count;
  }
  if (first != size) return std::nullopt;
  return TorchValue::of(std::move(parts));
}

}  // namespace

std::optional<TorchValue> run_torch_operator(const TorchCall& call, PolicyProblem& problem) {
  const std::string_view name = call.name();
  if (name == "lstm" || name == "gru") return torch_recurrence(call, problem);
  if (name == "split" || name == "split_with_sizes" || name == "chunk") {
    auto parts = parts_of(call);
    if (!parts) problem = call.misused("with sizes that are not those of the value");
    return parts;
  }
  const auto found = operators().find(name);
  if (found == operators().end()) {
    problem = {
        "E0754",
        fmt::format("calls `{}`, which is not supported ({})", printable(name), call.where()),
        "export the actor alone, or export it to ONNX with `torch.onnx.export`"};
    return std::nullopt;
  }
  auto value = found->second(call);
  if (value) return TorchValue::of(std::move(*value));
  problem = call.misused("in a way that is not supported");
  return std::nullopt;
}

}  // namespace eagerx::gen
