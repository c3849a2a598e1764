#include "generator/policy/network/graph/time.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

namespace eagerx::gen {

namespace {

using Kind = NetValue::Kind;

}  // namespace

TimeMask time_bit(std::int64_t axis) {
  return axis >= 0 && axis < 32 ? TimeMask{1} << static_cast<unsigned>(axis) : 0U;
}
bool has_time(TimeMask mask, std::int64_t axis) {
  return (mask & time_bit(axis)) != 0;
}
TimeMask without_axis(TimeMask mask, std::int64_t axis) {
  const TimeMask below = time_bit(axis) - 1;
  return (mask & below) | (mask >> 1U & ~below);
}
std::int64_t rank_of(const NetValue& value) {
  return static_cast<std::int64_t>(value.shape->size());
}
std::int64_t from_front(std::int64_t axis, std::int64_t rank) {
  return axis < 0 ? axis + rank : axis;
}
std::optional<TimeMask> time_of_each(const NetCall& call, const NetValue& result) {
  std::optional<TimeMask> mask;
  for (std::size_t i = 0; i < call.input_count(); ++i) {
    const NetValue& x = call.input(i);
    if (x.kind != Kind::data && x.kind != Kind::other) continue;
    if (!x.shape || x.shape->size() > result.shape->size() || result.shape->size() > kMaxRank) {
      return std::nullopt;
    }
    const TimeMask own = x.time << (result.shape->size() - x.shape->size());
    if (mask && *mask != own) return std::nullopt;
    mask = own;
  }
  return mask;
}

std::optional<TimeMask> time_unless(const NetValue& x, std::int64_t axis) {
  return has_time(x.time, axis) ? std::nullopt : std::optional(x.time);
}

namespace {

TimeMask with_axis(TimeMask mask, std::int64_t axis) {
  const TimeMask below = time_bit(axis) - 1;
  return (mask & below) | (mask & ~below) << 1U;
}

/// Axes of the call, from the back to the front; nothing if they are not given.
std::optional<Integers> axes_from_back(const NetCall& call, std::int64_t rank) {
  auto axes = call.integers(1, "axes");
  if (!axes || axes->empty()) return std::nullopt;
  for (std::int64_t& axis : *axes) axis = from_front(axis, rank);
  std::sort(axes->begin(), axes->end(), std::greater<>());
  return axes;
}
std::optional<TimeMask> without_axes(const NetCall& call, bool keeps) {
  const NetValue& x = call.input(0);
  const auto axes = axes_from_back(call, rank_of(x));
  if (!axes) return std::nullopt;  // all of them
  TimeMask mask = x.time;
  for (const std::int64_t axis : *axes) {
    if (has_time(x.time, axis)) return std::nullopt;
    if (!keeps) mask = without_axis(mask, axis);
  }
  return mask;
}

}  // namespace

std::optional<TimeMask> time_of_squeeze(const NetCall& call, const NetValue& /*result*/) {
  return without_axes(call, false);
}
std::optional<TimeMask> time_of_reduce(const NetCall& call, const NetValue& /*result*/) {
  return without_axes(call, call.integer("keepdims", 1) != 0);
}
std::optional<TimeMask> time_of_unsqueeze(const NetCall& call, const NetValue& result) {
  const auto axes = axes_from_back(call, rank_of(result)).value_or(Integers{});
  return std::accumulate(axes.rbegin(), axes.rend(), call.input(0).time, with_axis);
}

std::optional<TimeMask> time_but_last(const NetCall& call, const NetValue& /*result*/) {
  return time_unless(call.input(0), rank_of(call.input(0)) - 1);
}
std::optional<TimeMask> time_but_channels(const NetCall& call, const NetValue& /*result*/) {
  return time_unless(call.input(0), 1);
}
std::optional<TimeMask> time_of_image(const NetCall& call, const NetValue& /*result*/) {
  const TimeMask time = call.input(0).time;
  return time > time_bit(0) ? std::nullopt : std::optional(time);
}

namespace {

NetValue refused(const NetCall& call, const char* how) {
  return call.other({"E0613", "has " + call.who() + how,
                     "export the actor for one step, with its state as an input and an output"});
}

bool all_are_one(TimeMask mask, const Dims& dims) {
  for (std::size_t i = 0; i < dims.size(); ++i) {
    if (has_time(mask, static_cast<std::int64_t>(i)) && dims[i] != 1) return false;
  }
  return mask < time_bit(static_cast<std::int64_t>(dims.size()));
}

}  // namespace

std::optional<TimeMask> time_of_cell(const NetCall& call, const NetValue& /*result*/) {
  return has_time(call.input(0).time, 0) ? std::optional(time_bit(0)) : std::nullopt;
}

NetValue along_time(const NetCall& call, NetTimeRule rule, NetValue value) {
  value.time = 0;
  const bool is_data = value.kind == Kind::data;
  if (!call.state().follows_time || (!is_data && value.kind != Kind::other)) return value;
  const bool is_cell = is_data && rule == time_of_cell;
  bool any = is_cell;
  for (std::size_t i = 0; i < call.input_count(); ++i) any = any || call.input(i).time != 0;
  if (!any) return value;
  // A value that cannot be an action already has a problem, but its shape may be useful.
  const auto is_usual = [](const NetValue& some) {
    return some.shape && some.shape->size() <= kMaxRank;
  };
  if (!is_data && (!is_usual(value) || !is_usual(call.input(0)))) return value;
  const auto mask = rule != nullptr ? rule(call, value) : std::optional<TimeMask>();
  if (mask && all_are_one(*mask, *value.shape)) {
    value.time = *mask;
  } else if (is_data || value.part.role != NetPart::Role::none) {
    return refused(call,
                   is_cell ? " that does not run along the time" : " over the steps of a sequence");
  }
  return value;
}

}  // namespace eagerx::gen
