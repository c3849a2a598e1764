// The largest of several values. The operators that exporters write between the scores of actions
// and the index of the best one change the scores, but not their order.
#include <fmt/core.h>

#include "generator/policy/network/graph/operators.hpp"

namespace eagerx::gen {
namespace {

using Kind = NetValue::Kind;
using Role = NetPart::Role;

/// Scores x, or what has the order of x: the step of x.
std::optional<std::int32_t> scores_of(const NetValue& value) {
  if (value.kind == Kind::data) return value.step;
  const bool ordered = value.kind == Kind::other &&
                       (value.part.role == Role::ordered || value.part.role == Role::centred);
  return ordered ? std::optional(value.part.of) : std::nullopt;
}

/// Axis of the call, counted from the front, if it holds all values of `x`.
std::optional<std::size_t> whole_axis(const NetCall& call, const NetValue& x,
                                      std::int64_t otherwise) {
  const auto place = call.axis(x.shape ? x.shape->size() : 0, otherwise);
  if (place && (*x.shape)[*place] != element_count(*x.shape)) return std::nullopt;
  return place;
}

NetValue in_order_of(const NetCall& call, std::int32_t step, const std::optional<Dims>& shape,
                     Role role, const char* how) {
  NetValue value = call.misused(how, shape);
  value.problem = {"E0613", fmt::format("has {} {}", call.who(), how),
                   "export the network's outputs, or the index of the largest (ArgMax)"};
  value.part = {role, step, false, 0.0F};
  return value;
}

/// exp(x) / sum(exp(x)), or its logarithm.
NetValue softmax(const NetCall& call) {
  const NetValue& x = call.input(0);
  const auto step = scores_of(x);
  const bool whole = whole_axis(call, x, -1).has_value();
  if (!step || !whole) return call.misused("that is not of all outputs of a layer", x.shape);
  return in_order_of(call, *step, x.shape, Role::ordered,
                     "on the way to the action, without an ArgMax behind it");
}

NetValue arg_max(const NetCall& call) {
  const NetValue& x = call.input(0);
  const auto step = scores_of(x);
  const auto axis = whole_axis(call, x, 0);
  if (!step || !axis || call.integer("select_last_index", 0) != 0) {
    return call.misused("that is not of all outputs of a layer");
  }
  Dims shape = *x.shape;
  shape[*axis] = 1;
  if (call.integer("keepdims", 1) == 0) {
    shape.erase(shape.begin() + static_cast<std::ptrdiff_t>(*axis));
  }
  return in_order_of(call, *step, shape, Role::choice,
                     "whose result is not the action: something is calculated from it");
}

/// Its value is not needed, but its shape is: one number.
NetValue reduction(const NetCall& call) {
  const NetValue& x = call.input(0);
  const auto axes = call.integers(1, "axes");
  if (!x.shape || call.is_unreadable(1)) return call.misused("on the way to the action");
  const auto rank = static_cast<std::int64_t>(x.shape->size());
  Dims shape = *x.shape;
  const bool all = !axes || axes->empty();
  if (all && call.integer("noop_with_empty_axes", 0) == 0) shape.assign(shape.size(), 1);
  for (const std::int64_t axis : axes.value_or(std::vector<std::int64_t>{})) {
    const auto place = place_in(axis, rank);
    if (!place) return call.misused("with axes that are not there");
    shape[static_cast<std::size_t>(*place)] = 1;
  }
  if (call.integer("keepdims", 1) == 0) return call.misused("on the way to the action");
  return call.misused("on the way to the action", shape);
}

std::optional<TimeMask> time_of_softmax(const NetCall& call, const NetValue& /*result*/) {
  const NetValue& x = call.input(0);
  const std::int64_t axis = from_front(call.integer("axis", -1), rank_of(x));
  if (call.integer(kSoftmaxToLast, 0) != 0 && x.time >= time_bit(axis)) return std::nullopt;
  return time_unless(x, axis);
}
std::optional<TimeMask> time_of_arg_max(const NetCall& call, const NetValue& /*result*/) {
  const NetValue& x = call.input(0);
  const std::int64_t axis = from_front(call.integer("axis", 0), rank_of(x));
  if (has_time(x.time, axis)) return std::nullopt;
  return call.integer("keepdims", 1) != 0 ? x.time : without_axis(x.time, axis);
}

}  // namespace

NetValue shape_of_reduction(const NetCall& call) {
  return reduction(call);
}

NetValue joined_choices(const NetCall& call) {
  constexpr const char* kHow = "of choices and other values";
  std::vector<NetValue> scores;
  std::vector<std::uint32_t> groups;
  std::int64_t total = 0;
  for (std::size_t i = 0; i < call.input_count(); ++i) {
    const NetValue& choice = call.input(i);
    if (choice.kind != Kind::other || choice.part.role != Role::choice || !choice.shape) {
      return call.misused(kHow);
    }
    const std::int64_t count = call.count_after(choice.part.of);
    const auto own = choice.part.groups.empty()
                         ? std::vector<std::uint32_t>{static_cast<std::uint32_t>(count)}
                         : choice.part.groups;
    groups.insert(groups.end(), own.begin(), own.end());
    if (element_count(*choice.shape) != static_cast<std::int64_t>(own.size())) {
      return call.misused(kHow);
    }
    scores.push_back(data_value(choice.part.of, {1, count}));
    total += count;
  }
  const NetValue all = call.data_of(scores, Combination::Operation::join, {1, total});
  if (all.kind != Kind::data) return all;
  NetValue value =
      in_order_of(call, all.step, Dims{1, static_cast<std::int64_t>(groups.size())}, Role::choice,
                  "whose results are not the action: something is calculated from them");
  value.part.groups = std::move(groups);
  return value;
}

std::optional<NetValue> same_order(const NetCall& call, bool adds) {
  const auto one = [](const NetValue& value) {
    return value.shape && element_count(*value.shape) == 1;
  };
  for (const auto& [i, k] : {std::pair{0, 1}, std::pair{1, 0}}) {
    const NetValue& x = call.input(static_cast<std::size_t>(i));
    const NetValue& offset = call.input(static_cast<std::size_t>(k));
    const auto step = scores_of(x);
    if (!step || one(x) || !one(offset) || offset.kind == Kind::constant || (i == 1 && !adds)) {
      continue;
    }
    NetValue value = in_order_of(call, *step, broadcast(x.shape, offset.shape), Role::ordered,
                                 "of a value that is not constant");
    const auto operation = adds ? Combination::Operation::sum : Combination::Operation::difference;
    const auto exact = combined(call, call.input(0), call.input(1), operation);
    if (exact && exact->kind == Kind::data) value.part.exact = exact->step;
    return value;
  }
  return std::nullopt;
}

std::optional<NetValue> exact_of(const NetValue& value) {
  if (value.kind != Kind::other || value.part.role != Role::ordered || value.part.exact < 0) {
    return std::nullopt;
  }
  NetValue exact = data_value(value.part.exact, {});
  exact.shape = value.shape;
  exact.time = value.time;
  return exact;
}

std::vector<NetOperator> choice_operators() {
  return {{"ArgMax", arg_max, time_of_arg_max},
          {"Softmax", softmax, time_of_softmax, {.keeps_shape = true}},
          {"LogSoftmax", softmax, time_of_softmax},
          {"ReduceLogSumExp", reduction, time_of_reduce},
          {"ReduceMax", reduction, time_of_reduce}};
}

}  // namespace eagerx::gen
