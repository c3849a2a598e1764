// Selects elements by one or more indexes: parts of an observation, sizes of a shape.
#include <algorithm>
#include <utility>

#include "generator/policy/network/graph/operators.hpp"

namespace eagerx::gen {
namespace {

using Kind = NetValue::Kind;

/// The values at `which` along an axis, in that order.
NetValue picked_by_list(const NetCall& call, const NetValue& x, std::size_t axis,
                        const Integers& which) {
  Dims shape = *x.shape;
  const std::int64_t size = shape[axis];
  shape[axis] = static_cast<std::int64_t>(which.size());
  const auto count = element_count(shape);
  if (!count || *count > kMaxValues || !call.spend(*count)) return call.too_much();
  const auto behind = shape.begin() + static_cast<std::ptrdiff_t>(axis) + 1;
  const std::int64_t inner = element_count(Dims(behind, shape.end())).value_or(0);
  const std::int64_t outer = element_count(Dims(shape.begin(), behind - 1)).value_or(0);
  Reorder order;
  for (std::int64_t o = 0; o < outer; ++o) {
    for (const std::int64_t index : which) {
      const auto place = place_in(index, size);
      if (!place) return call.misused("with an index that is not there");
      for (std::int64_t i = 0; i < inner; ++i) {
        order.from.push_back(static_cast<std::uint32_t>((o * size + *place) * inner + i));
      }
    }
  }
  return reordered(call, x, std::move(order), std::move(shape));
}

/// The places that a Gather picks, which may be many.
std::optional<Integers> places_of(const NetCall& call, const NetValue& value) {
  constexpr std::int64_t kMost = 4096;
  if (value.kind != Kind::constant || !call.spend(kMost)) return integers_of(value);
  return read_integers(value.constant, kMost);
}

NetValue gather_values(const NetCall& call, const NetValue& x) {
  const std::optional<Integers> which = places_of(call, call.input(1));
  const auto axis = call.axis(x.shape ? x.shape->size() : 0);
  const std::optional<Dims>& form = call.input(1).shape;
  const bool one = which && which->size() == 1 && form && form->size() <= 1;
  const bool has_many =
      x.kind == Kind::data && which && which->size() > 1 && form && form->size() == 1 && axis;
  if (has_many) return picked_by_list(call, x, *axis, *which);
  if (!one || !axis) return call.misused("of several values");
  const auto index = place_in(which->front(), (*x.shape)[*axis]);
  if (!index) return call.misused("with an index that is not there");
  return picked(call, x, *axis, *index, 1, 1, !form->empty());
}

NetValue gather(const NetCall& call) {
  const NetValue& x = call.input(0);
  if (x.kind == Kind::data || x.kind == Kind::state || !x.remembered.empty()) {
    return gather_values(call, x);
  }
  const std::optional<Integers> from = integers_of(x);
  const std::optional<Integers> indices = integers_of(call.input(1));
  const std::int64_t axis = call.integer("axis", 0);
  if (!from || !indices || !x.shape || x.shape->size() != 1 || !call.input(1).shape ||
      (axis != 0 && axis != -1)) {
    return call.misused("on values that are not a shape");
  }
  Integers picked;
  const auto size = static_cast<std::int64_t>(from->size());
  for (const std::int64_t index : *indices) {
    const auto place = place_in(index, size);
    if (!place) return call.misused("with an index that is not there");
    picked.push_back((*from)[static_cast<std::size_t>(*place)]);
  }
  return integers_value(std::move(picked), *call.input(1).shape);
}

/// The last step is the one that is evaluated.
std::optional<TimeMask> time_of_gather(const NetCall& call, const NetValue& result) {
  const NetValue& x = call.input(0);
  const std::int64_t axis = from_front(call.integer("axis", 0), rank_of(x));
  const auto which = integers_of(call.input(1));
  if (has_time(x.time, axis) && which != Integers{-1}) return std::nullopt;
  const TimeMask rest = x.time & ~time_bit(axis);
  return rank_of(result) < rank_of(x) ? without_axis(rest, axis) : rest;
}

}  // namespace

std::vector<NetOperator> gather_operators() {
  return {{"Gather", gather, time_of_gather}};
}

}  // namespace eagerx::gen
