// Operators that move, name or shape values, and those that compute shapes.
#include <fmt/core.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "generator/formats/onnx/operators/value.hpp"

namespace eagerx::gen {
namespace {

using Kind = OnnxValue::Kind;

}  // namespace

OnnxValue integers_value(Integers integers, Dims shape) {
  OnnxValue value;
  value.kind = Kind::integers;
  value.shape = std::move(shape);
  value.integers = std::move(integers);
  return value;
}

OnnxValue integers_value(Integers integers) {
  Dims shape = {static_cast<std::int64_t>(integers.size())};
  return integers_value(std::move(integers), std::move(shape));
}

namespace {

OnnxValue constant_value(const OnnxCall& call, const onnx::TensorProto& tensor) {
  PolicyProblem problem;
  const std::optional<OnnxConstant> constant = make_constant(tensor, problem);
  if (!constant) return call.other(problem);
  OnnxValue value;
  value.kind = Kind::constant;
  value.shape = constant->dims;
  value.constant = *constant;
  return value;
}

}  // namespace

OnnxValue reshaped(const OnnxCall& call, const OnnxValue& x, const std::optional<Dims>& shape) {
  if (!shape || !x.shape || shape->size() > kMaxOnnxRank ||
      element_count(*shape) != element_count(*x.shape)) {
    return call.misused("that changes the number of values", shape);
  }
  if (x.kind == Kind::absent) return x;
  if (x.kind == Kind::constant && x.constant.transposed) {
    return call.misused("on a transposed constant", shape);
  }
  OnnxValue value = x;
  value.shape = shape;
  if (value.kind == Kind::constant) value.constant.dims = *shape;
  return value;
}

namespace {

OnnxValue identity(const OnnxCall& call) {
  if (call.input(0).kind == Kind::absent) return call.misused("without an input");
  return call.input(0);
}

std::string name_of_type(std::int64_t type) {
  const int number = type > 0 && type < 100 ? static_cast<int>(type) : 0;
  return onnx::TensorProto::DataType_IsValid(number)
             ? onnx::TensorProto::DataType_Name(static_cast<onnx::TensorProto::DataType>(number))
             : "an unknown type";
}

/// Integers become reals where they can be read as such: what is calculated from them afterwards
/// is not rounded. In half precision it would be, and in short integers they would wrap.
OnnxValue cast_integers(const OnnxCall& call, const Integers& integers, std::int64_t to) {
  const OnnxValue& x = call.input(0);
  if (to == onnx::TensorProto::FLOAT || to == onnx::TensorProto::DOUBLE) {
    if (!call.spend(static_cast<std::int64_t>(integers.size()))) return call.too_much();
    return made_constant(call, {integers.begin(), integers.end()}, *x.shape);
  }
  const bool stays = to == onnx::TensorProto::INT64 || to == onnx::TensorProto::INT32;
  const bool is_truth = to == onnx::TensorProto::BOOL;
  if (!stays && !is_truth) {
    return call.misused(fmt::format("to {}", name_of_type(to)), x.shape);
  }
  Integers result = integers;
  for (std::int64_t& value : result) {
    if (is_truth) value = value != 0 ? 1 : 0;
    const auto narrow = static_cast<std::int32_t>(value);
    if (to == onnx::TensorProto::INT32 && narrow != value) {
      return call.misused("of a number that does not fit", x.shape);
    }
  }
  return integers_value(std::move(result), *x.shape);
}

OnnxValue cast_to(const OnnxCall& call, std::int64_t to) {
  const OnnxValue& x = call.input(0);
  if (x.kind == Kind::absent) return call.misused("without an input");
  if (const auto integers = integers_of(x); integers && x.shape) {
    return cast_integers(call, *integers, to);
  }
  if (x.kind == Kind::data && to == onnx::TensorProto::BOOL) {
    if (const auto condition = condition_of(call, x)) return *condition;
  }
  const bool is_real = x.kind == Kind::constant && to != x.constant.tensor->data_type() &&
                       to != onnx::TensorProto::DOUBLE;  // else its numbers are rounded
  if ((x.kind == Kind::data || is_real) && to != onnx::TensorProto::FLOAT) {
    return call.misused(fmt::format("to {}", name_of_type(to)), x.shape);
  }
  return x;
}

OnnxValue cast(const OnnxCall& call) {
  return cast_to(call, call.integer("to", 0));
}

/// To the type of the second input.
OnnxValue cast_like(const OnnxCall& call) {
  const OnnxValue& like = call.input(1);
  if (like.kind == Kind::data) return cast_to(call, onnx::TensorProto::FLOAT);
  if (like.kind == Kind::constant) return cast_to(call, like.constant.tensor->data_type());
  return call.misused("to an unknown type", call.input(0).shape);
}

OnnxValue constant(const OnnxCall& call) {
  if (const auto* value = call.attribute("value"); value != nullptr && value->has_t()) {
    return constant_value(call, value->t());
  }
  if (const auto* ints = call.attribute("value_ints"); ints != nullptr) {
    return integers_value({ints->ints().begin(), ints->ints().end()});
  }
  if (const auto* integer = call.attribute("value_int"); integer != nullptr) {
    return integers_value({integer->i()}, {});
  }
  onnx::TensorProto tensor;
  tensor.set_name(call.node().output_size() > 0 ? call.node().output(0) : "");
  tensor.set_data_type(onnx::TensorProto::FLOAT);
  if (const auto* number = call.attribute("value_float"); number != nullptr) {
    tensor.add_float_data(number->f());
  } else if (const auto* numbers = call.attribute("value_floats"); numbers != nullptr) {
    tensor.add_dims(numbers->floats_size());
    *tensor.mutable_float_data() = numbers->floats();
  } else {
    return call.misused("whose value is not a plain tensor");
  }
  call.state().made.push_back(std::move(tensor));
  return constant_value(call, call.state().made.back());
}

OnnxValue flatten(const OnnxCall& call) {
  const OnnxValue& x = call.input(0);
  std::optional<Dims> shape;
  if (x.shape) {
    const auto rank = static_cast<std::int64_t>(x.shape->size());
    std::int64_t axis = call.integer("axis", 1);
    if (axis < -rank || axis > rank) return call.misused("with an axis that is not there");
    if (axis < 0) axis += rank;
    const auto middle = x.shape->begin() + axis;
    const auto total = [](auto first, auto last) {
      return std::accumulate(first, last, std::int64_t{1}, std::multiplies<>());
    };
    shape = Dims{total(x.shape->begin(), middle), total(middle, x.shape->end())};
  }
  return reshaped(call, x, shape);
}

/// The shape that `wanted` (with 0 for "as it is" and one -1 for "the rest") gives `from`.
std::optional<Dims> resolve_shape(const Dims& from, Dims wanted, bool allow_zero) {
  std::int64_t known = 1;
  std::optional<std::size_t> open;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (wanted[i] == 0 && !allow_zero) {
      if (i >= from.size()) return std::nullopt;
      wanted[i] = from[i];
    }
    if (wanted[i] == -1) {
      if (open) return std::nullopt;
      open = i;
      continue;
    }
    if (wanted[i] < 0 || (wanted[i] > 0 && known > kMaxElements / wanted[i])) return std::nullopt;
    known *= wanted[i];
  }
  const std::int64_t count = element_count(from).value_or(0);
  if (open) {
    if (known == 0 || count % known != 0) return std::nullopt;
    wanted[*open] = count / known;
  }
  return wanted;
}

OnnxValue reshape(const OnnxCall& call) {
  const OnnxValue& x = call.input(0);
  const std::optional<Integers> wanted = call.integers(1, "shape");
  if (!wanted || !x.shape) return call.misused("to a shape that is not constant");
  return reshaped(call, x, resolve_shape(*x.shape, *wanted, call.integer("allowzero", 0) != 0));
}

/// Axes of a Squeeze or Unsqueeze, sorted, counted from the front; nothing if they are out of
/// range.
std::optional<Integers> axes_of(const OnnxCall& call, std::size_t rank) {
  std::optional<Integers> axes = call.integers(1, "axes");
  if (!axes || axes->size() > kMaxOnnxRank) return std::nullopt;
  for (std::int64_t& axis : *axes) {
    const auto limit = static_cast<std::int64_t>(rank);
    if (axis < -limit || axis >= limit) return std::nullopt;
    if (axis < 0) axis += limit;
  }
  std::sort(axes->begin(), axes->end());
  return axes;
}

OnnxValue squeeze(const OnnxCall& call) {
  const OnnxValue& x = call.input(0);
  if (!x.shape) return reshaped(call, x, std::nullopt);
  const std::optional<Integers> axes = axes_of(call, x.shape->size());
  const bool all = call.input(1).kind == Kind::absent && call.attribute("axes") == nullptr;
  if (!axes && !all) return call.misused("with axes that are not there");
  Dims shape;
  for (std::size_t i = 0; i < x.shape->size(); ++i) {
    const bool named =
        axes && std::binary_search(axes->begin(), axes->end(), static_cast<std::int64_t>(i));
    if (!(named || (all && (*x.shape)[i] == 1))) shape.push_back((*x.shape)[i]);
  }
  return reshaped(call, x, shape);
}

OnnxValue unsqueeze(const OnnxCall& call) {
  const OnnxValue& x = call.input(0);
  const std::optional<Integers> given = call.integers(1, "axes");
  if (!x.shape || !given || given->size() > kMaxOnnxRank) {
    return call.misused("with axes that are not constant");
  }
  const std::optional<Integers> axes = axes_of(call, x.shape->size() + given->size());
  if (!axes) return call.misused("with axes that are not there");
  Dims shape = *x.shape;
  for (const std::int64_t axis : *axes) {
    if (static_cast<std::size_t>(axis) > shape.size()) return call.misused("with equal axes");
    shape.insert(shape.begin() + axis, 1);
  }
  return reshaped(call, x, shape);
}

OnnxValue expand(const OnnxCall& call) {
  const OnnxValue& x = call.input(0);
  const std::optional<Integers> wanted = call.integers(1, "shape");
  if (!wanted || !x.shape) return call.misused("to a shape that is not constant");
  const auto shape = broadcast(x.shape, Dims(*wanted));
  const bool repeats = x.kind == Kind::data && shape && element_count(*x.shape) == 1;
  if (!repeats || element_count(*shape) == 1) return reshaped(call, x, shape);
  const std::int64_t count = element_count(*shape).value_or(0);
  if (!call.spend(count)) return call.too_much();
  return reordered(call, x, Reorder{std::vector<std::uint32_t>(static_cast<std::size_t>(count))},
                   *shape);
}

OnnxValue shape_of(const OnnxCall& call) {
  const std::optional<Dims>& shape = call.input(0).shape;
  if (!shape) return call.misused("of an unknown shape");
  const auto rank = static_cast<std::int64_t>(shape->size());
  const auto position = [&](std::string_view name, std::int64_t otherwise) {
    const std::int64_t at = call.integer(name, otherwise);
    return std::clamp<std::int64_t>(at < 0 ? at + rank : at, 0, rank);
  };
  const std::int64_t start = position("start", 0);
  const std::int64_t end = std::max(start, position("end", rank));
  return integers_value({shape->begin() + start, shape->begin() + end});
}

OnnxValue constant_of_shape(const OnnxCall& call) {
  std::optional<Dims> shape = integers_of(call.input(0));
  if (shape && (shape->size() > kMaxOnnxRank || !element_count(*shape))) shape.reset();
  OnnxValue made = call.misused("on the way to the action", std::move(shape));
  const onnx::AttributeProto* value = call.attribute("value");
  PolicyProblem ignored;
  const auto constant = value != nullptr ? make_constant(value->t(), ignored) : std::nullopt;
  const auto numbers = constant ? read_floats(*constant, ignored) : std::nullopt;
  made.is_zero = value == nullptr || (numbers && numbers->size() == 1 && numbers->front() == 0.0F);
  return made;
}

}  // namespace

std::vector<OnnxOperatorEntry> shape_operators() {
  return {{"Identity", identity},
          {"Cast", cast},
          {"CastLike", cast_like},
          {"Constant", constant},
          {"Flatten", flatten},
          {"Reshape", reshape},
          {"Squeeze", squeeze},
          {"Expand", expand},
          {"Unsqueeze", unsqueeze},
          {"Shape", shape_of},
          {"ConstantOfShape", constant_of_shape}};
}

}  // namespace eagerx::gen
