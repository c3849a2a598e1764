// Files that take a sequence of any length from zeros on are evaluated one step at a time: cells
// remember what was before. That is the same as long as nothing else looks at the other steps, so
// their axis is followed, although its size is 1 here; all shapes look alike without it.
#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>

#include "generator/formats/onnx/operators/value.hpp"

namespace eagerx::gen {
namespace {

using Kind = OnnxValue::Kind;
using TimeMask = std::uint32_t;  // bit i: axis i may be the time
using TimeRule = std::optional<TimeMask> (*)(const OnnxCall& call, const OnnxValue& result);

TimeMask bit(std::int64_t axis) {
  return axis >= 0 && axis < 32 ? TimeMask{1} << static_cast<unsigned>(axis) : 0U;
}
bool has(TimeMask mask, std::int64_t axis) {
  return (mask & bit(axis)) != 0;
}
TimeMask without_axis(TimeMask mask, std::int64_t axis) {
  const TimeMask below = bit(axis) - 1;
  return (mask & below) | (mask >> 1U & ~below);
}
TimeMask with_axis(TimeMask mask, std::int64_t axis) {
  const TimeMask below = bit(axis) - 1;
  return (mask & below) | (mask & ~below) << 1U;
}

std::int64_t rank_of(const OnnxValue& value) {
  return static_cast<std::int64_t>(value.shape->size());
}
std::int64_t from_front(std::int64_t axis, std::int64_t rank) {
  return axis < 0 ? axis + rank : axis;
}
std::int64_t count_between(const Dims& dims, std::int64_t first, std::int64_t last) {
  return element_count(Dims(dims.begin() + first, dims.begin() + last)).value_or(0);
}

/// All inputs number by number, with axes that are counted from the back. A value of the last step
/// and one of each do not go together.
std::optional<TimeMask> time_of_each(const OnnxCall& call, const OnnxValue& result) {
  std::optional<TimeMask> mask;
  for (std::size_t i = 0; i < call.input_count(); ++i) {
    const OnnxValue& x = call.input(i);
    if (x.kind != Kind::data && x.kind != Kind::other) continue;
    if (!x.shape || x.shape->size() > result.shape->size() || result.shape->size() > kMaxOnnxRank) {
      return std::nullopt;
    }
    const TimeMask own = x.time << (result.shape->size() - x.shape->size());
    if (mask && *mask != own) return std::nullopt;
    mask = own;
  }
  return mask;
}

/// The input's axes, if `axis` is not the time.
std::optional<TimeMask> unless(const OnnxValue& x, std::int64_t axis) {
  return has(x.time, axis) ? std::nullopt : std::optional(x.time);
}

std::optional<TimeMask> time_of_matmul(const OnnxCall& call, const OnnxValue& /*result*/) {
  const OnnxValue& a = call.input(0);
  if (a.kind == Kind::data) return unless(a, rank_of(a) - 1);
  const OnnxValue& b = call.input(1);
  return unless(b, std::max(rank_of(b) - 2, std::int64_t{0}));
}
std::optional<TimeMask> time_of_gemm(const OnnxCall& call, const OnnxValue& /*result*/) {
  const bool left = call.input(0).kind == Kind::data;
  const OnnxValue& data = call.input(left ? 0 : 1);
  const bool transposed = call.integer(left ? "transA" : "transB", 0) != 0;
  const std::int64_t summed = left != transposed ? 1 : 0;
  if (has(data.time, summed)) return std::nullopt;
  return has(data.time, 1 - summed) ? bit(left ? 0 : 1) : 0U;
}

std::optional<TimeMask> time_of_transpose(const OnnxCall& call, const OnnxValue& result) {
  const OnnxValue& x = call.input(0);
  const onnx::AttributeProto* perm = call.attribute("perm");
  const std::int64_t rank = rank_of(result);
  TimeMask mask = 0;
  for (std::int64_t i = 0; i < rank; ++i) {
    const std::int64_t from = perm != nullptr ? perm->ints(static_cast<int>(i)) : rank - 1 - i;
    if (has(x.time, from)) mask |= bit(i);
  }
  return mask;
}

/// Axes of the call, from the back to the front; nothing if they are not given.
std::optional<Integers> axes_from_back(const OnnxCall& call, std::int64_t rank) {
  auto axes = call.integers(1, "axes");
  if (!axes || axes->empty()) return std::nullopt;
  for (std::int64_t& axis : *axes) axis = from_front(axis, rank);
  std::sort(axes->begin(), axes->end(), std::greater<>());
  return axes;
}
std::optional<TimeMask> without_axes(const OnnxCall& call, bool keeps) {
  const OnnxValue& x = call.input(0);
  const auto axes = axes_from_back(call, rank_of(x));
  if (!axes) return std::nullopt;  // all of them
  TimeMask mask = x.time;
  for (const std::int64_t axis : *axes) {
    if (has(x.time, axis)) return std::nullopt;
    if (!keeps) mask = without_axis(mask, axis);
  }
  return mask;
}
std::optional<TimeMask> time_of_squeeze(const OnnxCall& call, const OnnxValue& /*result*/) {
  return without_axes(call, false);
}
std::optional<TimeMask> time_of_reduce(const OnnxCall& call, const OnnxValue& /*result*/) {
  return without_axes(call, call.integer("keepdims", 1) != 0);
}
std::optional<TimeMask> time_of_unsqueeze(const OnnxCall& call, const OnnxValue& result) {
  const auto axes = axes_from_back(call, rank_of(result)).value_or(Integers{});
  return std::accumulate(axes.rbegin(), axes.rend(), call.input(0).time, with_axis);
}

/// [time, 1, n] to rows is harmless; to [1, time * n] is not.
std::optional<TimeMask> time_of_flatten(const OnnxCall& call, const OnnxValue& /*result*/) {
  const OnnxValue& x = call.input(0);
  const std::int64_t axis = from_front(call.integer("axis", 1), rank_of(x));
  TimeMask mask = 0;
  for (std::int64_t i = 0; i < rank_of(x); ++i) {
    if (has(x.time, i)) mask |= bit(i < axis ? 0 : 1);
  }
  return mask;
}

/// The time may become any axis of size 1 behind as many values as before that is not a 1 of the
/// file itself: one that is copied (0), the rest (-1), or computed from a shape.
std::optional<TimeMask> time_of_reshape(const OnnxCall& call, const OnnxValue& result) {
  const OnnxValue& x = call.input(0);
  const Integers wanted = call.integers(1, "shape").value_or(Integers{});
  const bool computed = call.input(1).kind == Kind::integers;
  TimeMask mask = 0;
  for (std::int64_t from = 0; from < rank_of(x); ++from) {
    if (!has(x.time, from)) continue;
    TimeMask places = 0;
    for (std::int64_t to = 0; to < rank_of(result); ++to) {
      const std::int64_t size = wanted.at(static_cast<std::size_t>(to));
      const bool open = size == 0 ? to == from : (size == -1 || computed);
      if (open && (*result.shape)[static_cast<std::size_t>(to)] == 1 &&
          count_between(*result.shape, 0, to) == count_between(*x.shape, 0, from)) {
        places |= bit(to);
      }
    }
    if (places == 0) return std::nullopt;
    mask |= places;
  }
  return mask;
}

/// The last step is the one that is evaluated.
std::optional<TimeMask> time_of_gather(const OnnxCall& call, const OnnxValue& result) {
  const OnnxValue& x = call.input(0);
  const std::int64_t axis = from_front(call.integer("axis", 0), rank_of(x));
  const auto which = integers_of(call.input(1));
  if (has(x.time, axis) && which != Integers{-1}) return std::nullopt;
  const TimeMask rest = x.time & ~bit(axis);
  return rank_of(result) < rank_of(x) ? without_axis(rest, axis) : rest;
}
std::optional<TimeMask> time_of_slice(const OnnxCall& call, const OnnxValue& /*result*/) {
  constexpr std::int64_t kEnd = std::numeric_limits<std::int32_t>::max();
  const OnnxValue& x = call.input(0);
  const auto front = [&](std::size_t i, std::string_view name) {
    const auto values = call.integers(i, name);
    return values && !values->empty() ? std::optional(values->front()) : std::nullopt;
  };
  const std::int64_t axis = from_front(front(3, "axes").value_or(0), rank_of(x));
  if (!has(x.time, axis)) return x.time;
  const auto start = front(1, "starts");
  const bool to_end = front(2, "ends").value_or(0) >= kEnd && front(4, "steps").value_or(1) == 1;
  if (to_end && start == -1) return x.time & ~bit(axis);
  return to_end && start == 0 ? std::optional(x.time) : std::nullopt;
}

std::optional<TimeMask> time_of_split(const OnnxCall& call, const OnnxValue& /*result*/) {
  return unless(call.input(0), from_front(call.integer("axis", 0), rank_of(call.input(0))));
}
std::optional<TimeMask> time_of_concat(const OnnxCall& call, const OnnxValue& result) {
  if (call.input_count() == 1) return call.input(0).time;
  const std::int64_t axis = from_front(call.integer("axis", 0), rank_of(result));
  return has(call.input(0).time, axis) ? std::nullopt : time_of_each(call, result);
}

std::optional<TimeMask> time_of_last_axis(const OnnxCall& call, const OnnxValue& /*result*/) {
  return unless(call.input(0), rank_of(call.input(0)) - 1);
}
std::optional<TimeMask> time_of_softmax(const OnnxCall& call, const OnnxValue& /*result*/) {
  const OnnxValue& x = call.input(0);
  constexpr std::int64_t kOneAxis = 13;  // before, also all behind it
  const bool old = call.opset() < kOneAxis;
  const std::int64_t axis = from_front(call.integer("axis", old ? 1 : -1), rank_of(x));
  if (old && x.time >= bit(axis)) return std::nullopt;
  return unless(x, axis);
}
std::optional<TimeMask> time_of_arg_max(const OnnxCall& call, const OnnxValue& /*result*/) {
  const OnnxValue& x = call.input(0);
  const std::int64_t axis = from_front(call.integer("axis", 0), rank_of(x));
  if (has(x.time, axis)) return std::nullopt;
  return call.integer("keepdims", 1) != 0 ? x.time : without_axis(x.time, axis);
}

std::optional<TimeMask> time_of_by_channel(const OnnxCall& call, const OnnxValue& /*result*/) {
  return unless(call.input(0), 1);
}
/// Images one by one.
std::optional<TimeMask> time_of_image(const OnnxCall& call, const OnnxValue& /*result*/) {
  const TimeMask time = call.input(0).time;
  return time > bit(0) ? std::nullopt : std::optional(time);
}

/// The rule of an operator; nullptr for those that may look at anything.
TimeRule rule_of(std::string_view name) {
  static constexpr std::pair<std::string_view, TimeRule> kRules[] = {
      {"MatMul", time_of_matmul},
      {"Gemm", time_of_gemm},
      {"Transpose", time_of_transpose},
      {"Squeeze", time_of_squeeze},
      {"Unsqueeze", time_of_unsqueeze},
      {"Flatten", time_of_flatten},
      {"Reshape", time_of_reshape},
      {"Gather", time_of_gather},
      {"Slice", time_of_slice},
      {"Split", time_of_split},
      {"Concat", time_of_concat},
      {"LayerNormalization", time_of_last_axis},
      {"Softmax", time_of_softmax},
      {"LogSoftmax", time_of_softmax},
      {"ArgMax", time_of_arg_max},
      {"ReduceMean", time_of_reduce},
      {"ReduceMax", time_of_reduce},
      {"ReduceSum", time_of_reduce},
      {"ReduceL2", time_of_reduce},
      {"Conv", time_of_image},
      {"ReduceLogSumExp", time_of_reduce},
      {"MaxPool", time_of_image},
      {"BatchNormalization", time_of_by_channel},
      {"AveragePool", time_of_image},
      {"GlobalMaxPool", time_of_image},
      {"Pad", time_of_image},
      {"GlobalAveragePool", time_of_image}};
  constexpr std::string_view kEach[] = {
      "Add",         "CastLike", "Celu",      "Clip", "Cast",     "Div",      "Dropout",
      "Elu",         "Erf",      "Sin",       "Cos",  "Exp",      "Abs",      "Gelu",
      "Expand",      "Neg",      "LeakyRelu", "Max",  "Min",      "Identity", "Mul",
      "PRelu",       "Pow",      "Selu",      "Relu", "Softplus", "Sqrt",     "Sub",
      "Sigmoid",     "Sum",      "Tanh",      "Sign", "Greater",  "Less",     "GreaterOrEqual",
      "LessOrEqual", "Equal",    "Not",       "And",  "Or",       "Where"};
  for (const auto& [known, rule] : kRules) {
    if (known == name) return rule;
  }
  return std::find(std::begin(kEach), std::end(kEach), name) != std::end(kEach) ? time_of_each
                                                                                : nullptr;
}

OnnxValue refused(const OnnxCall& call, const char* how) {
  return call.other({"E0613", "has " + call.who() + how,
                     "export the actor for one step, with its state as an input and an output"});
}

bool all_are_one(TimeMask mask, const Dims& dims) {
  for (std::size_t i = 0; i < dims.size(); ++i) {
    if (has(mask, static_cast<std::int64_t>(i)) && dims[i] != 1) return false;
  }
  return mask < bit(static_cast<std::int64_t>(dims.size()));
}

}  // namespace

OnnxValue along_time(const OnnxCall& call, OnnxValue value) {
  value.time = 0;
  const bool is_data = value.kind == Kind::data;
  if (!call.state().follows_time || (!is_data && value.kind != Kind::other)) return value;
  if (is_data && (call.node().op_type() == "GRU" || call.node().op_type() == "LSTM")) {
    if (!has(call.input(0).time, 0)) return refused(call, " that does not run along the time");
    value.time = bit(0);
    return value;
  }
  bool any = false;
  for (std::size_t i = 0; i < call.input_count(); ++i) any = any || call.input(i).time != 0;
  if (!any) return value;
  const TimeRule rule = rule_of(call.node().op_type());
  // What cannot be an action by itself has its problem already, but its shape may be of use.
  const auto is_usual = [](const OnnxValue& some) {
    return some.shape && some.shape->size() <= kMaxOnnxRank;
  };
  if (!is_data && (!is_usual(value) || !is_usual(call.input(0)))) return value;
  const auto mask = rule != nullptr ? rule(call, value) : std::optional<TimeMask>();
  if (mask && all_are_one(*mask, *value.shape)) {
    value.time = *mask;
  } else if (is_data || value.part.role != OnnxPart::Role::none) {
    return refused(call, " over the steps of a sequence");
  }
  return value;
}

}  // namespace eagerx::gen
