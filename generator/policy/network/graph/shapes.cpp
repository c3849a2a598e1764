// Operators that move, name or shape values, and those that compute shapes.
#include <fmt/core.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "generator/policy/network/graph/operators.hpp"

namespace eagerx::gen {
namespace {

using Kind = NetValue::Kind;

}  // namespace

NetValue integers_value(Integers integers, Dims shape) {
  NetValue value;
  value.kind = Kind::integers;
  value.shape = std::move(shape);
  value.integers = std::move(integers);
  return value;
}

NetValue integers_value(Integers integers) {
  Dims shape = {static_cast<std::int64_t>(integers.size())};
  return integers_value(std::move(integers), std::move(shape));
}

NetValue constant_value(const NetTensor& tensor) {
  NetValue value;
  value.kind = Kind::constant;
  value.shape = tensor.dims;
  value.constant = {&tensor, tensor.dims, false};
  return value;
}

NetValue reshaped(const NetCall& call, const NetValue& x, const std::optional<Dims>& shape) {
  if (!shape || !x.shape || shape->size() > kMaxRank ||
      element_count(*shape) != element_count(*x.shape)) {
    return call.misused("that changes the number of values", shape);
  }
  if (x.kind == Kind::absent) return x;
  if (x.kind == Kind::constant && x.constant.transposed) {
    return call.misused("on a transposed constant", shape);
  }
  NetValue value = x;
  value.shape = shape;
  if (value.kind == Kind::constant) value.constant.dims = *shape;
  return value;
}

namespace {

NetValue identity(const NetCall& call) {
  if (call.input(0).kind == Kind::absent) return call.misused("without an input");
  return call.input(0);
}

std::string_view shown_type(std::int64_t type) {
  return onnx_type_name(type > 0 && type < 100 ? type : 0).value_or("an unknown type");
}

/// Integers become reals where they can be read as such: what is calculated from them afterwards
/// is not rounded. In half precision it would be, and in short integers they would wrap.
NetValue cast_integers(const NetCall& call, const Integers& integers, std::int64_t to) {
  const NetValue& x = call.input(0);
  if (to == onnx_number(ElementType::float32) || to == onnx_number(ElementType::float64)) {
    if (!call.spend(static_cast<std::int64_t>(integers.size()))) return call.too_much();
    return made_constant(call, {integers.begin(), integers.end()}, *x.shape);
  }
  const bool narrows = to == onnx_number(ElementType::int32);
  const bool stays = narrows || to == onnx_number(ElementType::int64);
  const bool is_truth = to == onnx_number(ElementType::boolean);
  if (!stays && !is_truth) {
    return call.misused(fmt::format("to {}", shown_type(to)), x.shape);
  }
  Integers result = integers;
  for (std::int64_t& value : result) {
    if (is_truth) value = value != 0 ? 1 : 0;
    const auto narrow = static_cast<std::int32_t>(value);
    if (narrows && narrow != value) {
      return call.misused("of a number that does not fit", x.shape);
    }
  }
  return integers_value(std::move(result), *x.shape);
}

NetValue cast_to(const NetCall& call, std::int64_t to) {
  const NetValue& x = call.input(0);
  if (x.kind == Kind::absent) return call.misused("without an input");
  if (const auto integers = integers_of(x); integers && x.shape) {
    return cast_integers(call, *integers, to);
  }
  if (x.kind == Kind::data && to == onnx_number(ElementType::boolean)) {
    if (const auto condition = condition_of(call, x)) return *condition;
  }
  const bool is_real = x.kind == Kind::constant && to != onnx_number(x.constant.tensor->type) &&
                       to != onnx_number(ElementType::float64);  // else its numbers are rounded
  // Data in halves is calculated in float32, which is closer to the file's weights.
  const bool is_half = x.kind == Kind::data && to == onnx_number(ElementType::float16);
  call.state().has_halves = call.state().has_halves || is_half;
  if ((x.kind == Kind::data || is_real) && !is_half && to != onnx_number(ElementType::float32)) {
    return call.misused(fmt::format("to {}", shown_type(to)), x.shape);
  }
  return x;
}

NetValue cast(const NetCall& call) {
  return cast_to(call, call.integer("to", 0));
}

/// To the type of the second input.
NetValue cast_like(const NetCall& call) {
  const NetValue& like = call.input(1);
  if (like.kind == Kind::data) return cast_to(call, onnx_number(ElementType::float32));
  if (like.kind == Kind::constant) return cast_to(call, onnx_number(like.constant.tensor->type));
  return call.misused("to an unknown type", call.input(0).shape);
}

NetValue constant(const NetCall& call) {
  if (const auto* tensor = call.attribute("value"); tensor != nullptr && tensor->value) {
    const NetValue& value = *tensor->value;
    return value.kind == Kind::other ? call.other(value.problem) : value;
  }
  if (const auto* list = call.attribute("value_ints"); list != nullptr) {
    return integers_value(list->integers());
  }
  if (call.attribute("value_int") != nullptr)
    return integers_value({call.integer("value_int", 0)}, {});
  if (call.attribute("value_float") != nullptr) {
    return made_constant(call, call.real("value_float", 0.0F));
  }
  if (const auto* list = call.attribute("value_floats"); list != nullptr) {
    return made_constant(call, list->reals, {static_cast<std::int64_t>(list->reals.size())});
  }
  return call.misused("whose value is not a plain tensor");
}

NetValue flatten(const NetCall& call) {
  const NetValue& x = call.input(0);
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

NetValue reshape(const NetCall& call) {
  const NetValue& x = call.input(0);
  const std::optional<Integers> wanted = call.integers(1, "shape");
  if (!wanted || !x.shape) return call.misused("to a shape that is not constant");
  return reshaped(call, x, resolve_shape(*x.shape, *wanted, call.integer("allowzero", 0) != 0));
}

/// Axes of a Squeeze or Unsqueeze, sorted, counted from the front; nothing if they are out of
/// range.
std::optional<Integers> axes_of(const NetCall& call, std::size_t rank) {
  std::optional<Integers> axes = call.integers(1, "axes");
  if (!axes || axes->size() > kMaxRank) return std::nullopt;
  for (std::int64_t& axis : *axes) {
    const auto place = place_in(axis, static_cast<std::int64_t>(rank));
    if (!place) return std::nullopt;
    axis = *place;
  }
  std::sort(axes->begin(), axes->end());
  return axes;
}

NetValue squeeze(const NetCall& call) {
  const NetValue& x = call.input(0);
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

NetValue unsqueeze(const NetCall& call) {
  const NetValue& x = call.input(0);
  const std::optional<Integers> given = call.integers(1, "axes");
  if (!x.shape || !given || given->size() > kMaxRank) {
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

NetValue expand(const NetCall& call) {
  const NetValue& x = call.input(0);
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

NetValue shape_of(const NetCall& call) {
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

NetValue constant_of_shape(const NetCall& call) {
  std::optional<Dims> shape = integers_of(call.input(0));
  if (shape && (shape->size() > kMaxRank || !element_count(*shape))) shape.reset();
  NetValue made = call.misused("on the way to the action", std::move(shape));
  const NetAttribute* filling = call.attribute("value");
  made.is_zero = filling == nullptr || (filling->value && scalar_of(*filling->value) == 0.0F);
  return made;
}

std::int64_t count_between(const Dims& dims, std::int64_t first, std::int64_t last) {
  return element_count(Dims(dims.begin() + first, dims.begin() + last)).value_or(0);
}

/// [time, 1, n] to rows is harmless; to [1, time * n] is not.
std::optional<TimeMask> time_of_flatten(const NetCall& call, const NetValue& /*result*/) {
  const NetValue& x = call.input(0);
  const std::int64_t axis = from_front(call.integer("axis", 1), rank_of(x));
  TimeMask mask = 0;
  for (std::int64_t i = 0; i < rank_of(x); ++i) {
    if (has_time(x.time, i)) mask |= time_bit(i < axis ? 0 : 1);
  }
  return mask;
}

/// The time may become any axis of size 1 behind as many values as before that is not a 1 of the
/// file itself: one that is copied (0), the rest (-1), or computed from a shape.
std::optional<TimeMask> time_of_reshape(const NetCall& call, const NetValue& result) {
  const NetValue& x = call.input(0);
  const Integers wanted = call.integers(1, "shape").value_or(Integers{});
  const bool computed = call.input(1).kind == Kind::integers;
  TimeMask mask = 0;
  for (std::int64_t from = 0; from < rank_of(x); ++from) {
    if (!has_time(x.time, from)) continue;
    TimeMask places = 0;
    for (std::int64_t to = 0; to < rank_of(result); ++to) {
      const std::int64_t size = wanted.at(static_cast<std::size_t>(to));
      const bool open = size == 0 ? to == from : (size == -1 || computed);
      if (open && (*result.shape)[static_cast<std::size_t>(to)] == 1 &&
          count_between(*result.shape, 0, to) == count_between(*x.shape, 0, from)) {
        places |= time_bit(to);
      }
    }
    if (places == 0) return std::nullopt;
    mask |= places;
  }
  return mask;
}

}  // namespace

std::vector<NetOperator> shape_operators() {
  return {{"Identity", identity, time_of_each},           {"Cast", cast, time_of_each},
          {"CastLike", cast_like, time_of_each},          {"Constant", constant, nullptr},
          {"Flatten", flatten, time_of_flatten},          {"Reshape", reshape, time_of_reshape},
          {"Squeeze", squeeze, time_of_squeeze},          {"Expand", expand, time_of_each},
          {"Unsqueeze", unsqueeze, time_of_unsqueeze},    {"Shape", shape_of, nullptr},
          {"ConstantOfShape", constant_of_shape, nullptr}};
}

}  // namespace eagerx::gen
