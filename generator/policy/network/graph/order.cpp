// Operators that pick values or put them in another order.
#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "generator/policy/network/graph/operators.hpp"

namespace eagerx::gen {
namespace {

using Kind = NetValue::Kind;

/// Integers with one axis, as those of a shape.
bool is_list(const NetValue& integers) {
  return integers.shape && integers.shape->size() == 1;
}

std::int64_t count_of(const Dims& dims) {
  return element_count(dims).value_or(0);
}

/// Distance between neighbours along each axis, row-major.
Integers strides_of(const Dims& dims) {
  Integers strides(dims.size(), 1);
  for (std::size_t i = dims.size(); i-- > 1;) strides[i - 1] = strides[i] * dims[i];
  return strides;
}

/// Where the values of `shape`, row-major, lie in the input: `first`, and `strides` along its axes.
Reorder indices(const Dims& shape, std::int64_t first, const Integers& strides) {
  Reorder order;
  const auto count = static_cast<std::size_t>(count_of(shape));
  order.from.reserve(count);
  Integers at(shape.size(), 0);
  std::int64_t from = first;
  for (std::size_t i = 0; i < count; ++i) {
    order.from.push_back(static_cast<std::uint32_t>(from));
    for (std::size_t axis = shape.size(); axis-- > 0;) {
      from += strides[axis];
      if (++at[axis] < shape[axis]) break;
      from -= strides[axis] * shape[axis];
      at[axis] = 0;
    }
  }
  return order;
}

/// The reordering of values of `dims` when axis `order[i]` moves to place i.
Reorder transposition(const Dims& dims, const Integers& order) {
  const Integers strides = strides_of(dims);
  Dims shape;
  Integers moved;
  for (const std::int64_t axis : order) {
    shape.push_back(dims[static_cast<std::size_t>(axis)]);
    moved.push_back(strides[static_cast<std::size_t>(axis)]);
  }
  return indices(shape, 0, moved);
}

NetValue transpose(const NetCall& call) {
  const NetValue& x = call.input(0);
  if (!x.shape) return call.misused("of an unknown shape");
  const std::size_t rank = x.shape->size();
  Integers order(rank);
  std::iota(order.rbegin(), order.rend(), 0);  // reversed is the default
  if (const auto* perm = call.attribute("perm"); perm != nullptr) {
    order = perm->integers();
  }
  Integers sorted = order;
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 0; i < rank; ++i) {
    if (sorted.size() != rank || sorted[i] != static_cast<std::int64_t>(i)) {
      return call.misused("with axes that are not there");
    }
  }
  Dims shape;
  std::int64_t last = -1;
  bool in_order = true;  // axes of size one may go anywhere
  for (const std::int64_t axis : order) {
    const std::int64_t dim = (*x.shape)[static_cast<std::size_t>(axis)];
    shape.push_back(dim);
    if (dim == 1) continue;
    in_order = in_order && axis > last;
    last = axis;
  }
  if (in_order) return reshaped(call, x, shape);
  if (x.kind == Kind::data) {
    if (!call.spend(count_of(*x.shape))) return call.too_much();
    return reordered(call, x, transposition(*x.shape, order), shape);
  }
  if (x.kind != Kind::constant || rank != 2) return call.misused("that reorders values", shape);
  NetValue value = x;
  value.shape = shape;
  value.constant.dims = shape;
  value.constant.transposed = !value.constant.transposed;
  return value;
}

/// Layers `first` to `first + count` of a state.
NetValue part_of_state(const NetValue& x, std::int64_t first, std::int64_t count, Dims shape) {
  NetValue value = x;
  value.state.slot += first;
  value.slots = count;
  value.shape = std::move(shape);
  return value;
}

}  // namespace

NetValue picked(const NetCall& call, const NetValue& x, std::size_t axis, std::int64_t first,
                std::int64_t count, std::int64_t step, bool keeps_axis) {
  const Dims& dims = *x.shape;
  Dims shape = dims;
  shape[axis] = count;
  Integers strides = strides_of(dims);
  const std::int64_t start = first * strides[axis];
  strides[axis] *= step;
  Dims result = shape;
  if (!keeps_axis) result.erase(result.begin() + static_cast<std::ptrdiff_t>(axis));
  if (x.kind == Kind::state) {
    if (axis != 0 || step != 1) return call.misused("of a part of a state");
    return part_of_state(x, first, count, std::move(result));
  }
  if (count == dims[axis] && step == 1) return reshaped(call, x, result);
  if (x.kind != Kind::data) return call.misused("on something that is not a layer");
  if (!call.spend(count_of(shape))) return call.too_much();
  return reordered(call, x, indices(shape, start, strides), std::move(result));
}

namespace {

/// The new states of several layers, one after the other.
NetValue joined_state(const NetCall& call) {
  std::vector<NetRemembered> all;
  std::optional<Dims> shape = call.input(0).shape;
  for (std::size_t i = 0; i < call.input_count(); ++i) {
    const auto& part = call.input(i).remembered;
    if (part.empty()) return call.misused("of states and other values");
    constexpr std::size_t kMostLayers = 1024;  // each Concat may double them
    if (all.size() + part.size() > kMostLayers) return call.misused("of too many states");
    all.insert(all.end(), part.begin(), part.end());
  }
  if (call.integer("axis", 0) != 0) return call.misused("that does not put layers one by one");
  if (shape && !shape->empty()) shape->front() = static_cast<std::int64_t>(all.size());
  NetValue value = call.misused("that joins states on the way to the action", shape);
  value.remembered = std::move(all);
  return value;
}

/// Where the values of `data` come from: a step that is no Reorder, and their places in it.
std::pair<std::int32_t, Reorder> origin_of(const NetCall& call, const NetValue& data) {
  std::int32_t step = data.step;
  Reorder order;
  order.from.resize(static_cast<std::size_t>(count_of(*data.shape)));
  std::iota(order.from.begin(), order.from.end(), 0U);
  while (step >= 0) {
    const NetStep& last = call.state().steps[static_cast<std::size_t>(step)];
    const auto* before = last.form<Reorder>();
    if (before == nullptr) break;
    if (!call.spend(count_of(*data.shape))) break;
    for (std::uint32_t& place : order.from) place = before->from[place];
    step = last.before;
  }
  return {step, std::move(order)};
}

/// Values of several layers side by side, each of `rows` rows.
NetValue joined_branches(const NetCall& call, const std::vector<NetValue>& values,
                         std::int64_t rows, Dims shape) {
  NetValue whole = call.data_of(values, Combination::Operation::join, shape);
  if (rows == 1 || whole.kind != Kind::data) return whole;
  Reorder order;
  for (std::int64_t row = 0; row < rows; ++row) {
    std::int64_t first = 0;
    for (const NetValue& value : values) {
      const std::int64_t count = count_of(*value.shape);
      for (std::int64_t i = row * (count / rows); i < (row + 1) * (count / rows); ++i) {
        order.from.push_back(static_cast<std::uint32_t>(first + i));
      }
      first += count;
    }
  }
  return reordered(call, whole, std::move(order), std::move(shape));
}

/// Parts of one layer, or of the observation, or of several layers, side by side.
NetValue joined_data(const NetCall& call) {
  const NetValue& first = call.input(0);
  const auto given = call.axis(first.shape->size());
  if (!given) return call.misused("with an axis that is not there");
  const std::size_t place = *given;
  const auto axis = static_cast<std::ptrdiff_t>(place);
  const auto inner = [&](const Dims& dims) {
    return count_of(Dims(dims.begin() + axis, dims.end()));
  };
  Dims shape = *first.shape;
  shape[place] = 0;
  std::vector<std::pair<std::int32_t, Reorder>> parts;
  std::vector<NetValue> values;
  bool one_origin = true;
  for (std::size_t i = 0; i < call.input_count(); ++i) {
    const NetValue& part = call.input(i);
    if (part.kind != Kind::data) return call.misused("of a layer and other values");
    Dims other = *part.shape;
    if (other.size() != shape.size()) return call.misused("of values of other shapes");
    shape[place] += std::exchange(other[place], shape[place]);
    other[place] = shape[place];
    if (other != shape) return call.misused("of values of other shapes");
    if (!call.spend(2 * count_of(*part.shape))) return call.too_much();
    parts.push_back(origin_of(call, part));
    one_origin = one_origin && parts.back().first == parts.front().first;
    values.push_back(part);
  }
  const std::int64_t outer = count_of(Dims(shape.begin(), shape.begin() + axis));
  if (!one_origin) return joined_branches(call, values, outer, std::move(shape));
  Reorder order;
  for (std::int64_t row = 0; row < outer; ++row) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const std::int64_t count = inner(*call.input(i).shape);
      const auto begin = parts[i].second.from.begin() + row * count;
      order.from.insert(order.from.end(), begin, begin + count);
    }
  }
  NetValue whole = first;
  whole.step = parts.front().first;
  bool same = call.count_after(whole.step) == static_cast<std::int64_t>(order.from.size());
  for (std::size_t i = 0; same && i < order.from.size(); ++i) same = order.from[i] == i;
  if (!same) return reordered(call, whole, std::move(order), std::move(shape));
  whole.shape = std::move(shape);
  return whole;
}

NetValue concat(const NetCall& call) {
  if (call.input_count() == 1 && call.input(0).kind != Kind::absent) return call.input(0);
  if (!call.input(0).remembered.empty()) return joined_state(call);
  if (call.input(0).kind == Kind::data) return joined_data(call);
  if (call.input(0).part.role == NetPart::Role::choice) return joined_choices(call);
  Integers all;
  for (std::size_t i = 0; i < call.input_count(); ++i) {
    const std::optional<Integers> part = integers_of(call.input(i));
    if (!part || !is_list(call.input(i)) || all.size() + part->size() > kMaxRank) {
      return call.misused("of several values");
    }
    all.insert(all.end(), part->begin(), part->end());
  }
  return integers_value(std::move(all));
}

/// One axis of a Slice, from opset 10 on in inputs: start, end, step.
NetValue slice(const NetCall& call) {
  const NetValue& x = call.input(0);
  const auto starts = call.integers(1, "starts");
  const auto ends = call.integers(2, "ends");
  auto axes = call.integers(3, "axes");
  const auto steps = call.integers(4, "steps");
  if (!starts || !ends || starts->size() != 1 || ends->size() != 1) {
    return call.misused("of more than one axis, or without constant ends", std::nullopt);
  }
  if (call.is_unreadable(3) || call.is_unreadable(4)) {
    return call.misused("with axes or steps that are not constant");
  }
  if (!axes) axes = Integers{0};
  const std::int64_t step = steps ? (steps->size() == 1 ? steps->front() : 0) : 1;
  const auto from = integers_of(x);
  if (from && !is_list(x)) return call.misused("on values that are not a shape");
  const Dims dims = x.shape.value_or(Dims{});
  const auto rank = static_cast<std::int64_t>(dims.size());
  const auto given = axes->size() == 1 ? place_in(axes->front(), rank) : std::nullopt;
  if (!given || step < 1) return call.misused("with axes or steps that are not there");
  const auto axis = static_cast<std::size_t>(*given);
  const std::int64_t size = dims[axis];
  const auto place = [size](std::int64_t at) {
    return std::clamp<std::int64_t>(at < 0 ? (at < -size ? 0 : at + size) : at, 0, size);
  };
  const std::int64_t first = place(starts->front());
  const std::int64_t last = place(ends->front());
  if (last <= first || step > size) return call.misused("that keeps no values");
  const std::int64_t count = (last - first + step - 1) / step;
  if (from) {
    Integers some;
    for (std::int64_t i = first; i < last; i += step) {
      some.push_back((*from)[static_cast<std::size_t>(i)]);
    }
    return integers_value(std::move(some));
  }
  if (x.kind != Kind::data && x.kind != Kind::state) return call.misused("on a constant");
  return picked(call, x, axis, first, count, step, true);
}

std::optional<TimeMask> time_of_transpose(const NetCall& call, const NetValue& result) {
  const NetValue& x = call.input(0);
  const NetAttribute* perm = call.attribute("perm");
  const std::int64_t rank = rank_of(result);
  TimeMask mask = 0;
  for (std::int64_t i = 0; i < rank; ++i) {
    const std::int64_t from =
        perm != nullptr ? perm->integers()[static_cast<std::size_t>(i)] : rank - 1 - i;
    if (has_time(x.time, from)) mask |= time_bit(i);
  }
  return mask;
}

std::optional<TimeMask> time_of_slice(const NetCall& call, const NetValue& /*result*/) {
  constexpr std::int64_t kEnd = std::numeric_limits<std::int32_t>::max();
  const NetValue& x = call.input(0);
  const auto front = [&](std::size_t i, std::string_view name) {
    const auto values = call.integers(i, name);
    return values && !values->empty() ? std::optional(values->front()) : std::nullopt;
  };
  const std::int64_t axis = from_front(front(3, "axes").value_or(0), rank_of(x));
  if (!has_time(x.time, axis)) return x.time;
  const auto start = front(1, "starts");
  const bool to_end = front(2, "ends").value_or(0) >= kEnd && front(4, "steps").value_or(1) == 1;
  if (to_end && start == -1) return x.time & ~time_bit(axis);
  return to_end && start == 0 ? std::optional(x.time) : std::nullopt;
}

std::optional<TimeMask> time_of_split(const NetCall& call, const NetValue& /*result*/) {
  return time_unless(call.input(0), from_front(call.integer("axis", 0), rank_of(call.input(0))));
}
std::optional<TimeMask> time_of_concat(const NetCall& call, const NetValue& result) {
  if (call.input_count() == 1) return call.input(0).time;
  const std::int64_t axis = from_front(call.integer("axis", 0), rank_of(result));
  return has_time(call.input(0).time, axis) ? std::nullopt : time_of_each(call, result);
}

/// Output `i`.
NetValue split_part(const NetCall& call, int i) {
  const NetValue& x = call.input(0);
  if ((x.kind != Kind::data && x.kind != Kind::state) || !x.shape) {
    return call.misused("on something that is not a layer");
  }
  const auto place = call.axis(x.shape->size());
  if (!place) return call.misused("with an axis that is not there");
  const std::int64_t size = (*x.shape)[*place];
  const std::int64_t parts = call.integer("num_outputs", call.node().outputs);
  // Every output looks at the sizes of all.
  const NetAttribute* given = call.attribute("split");
  const std::int64_t looked_at = given != nullptr
                                     ? static_cast<std::int64_t>(given->integers().size())
                                     : std::clamp(parts, std::int64_t{1}, size);
  if (!call.spend(looked_at + static_cast<std::int64_t>(call.node().attributes.size())))
    return call.too_much();
  if (call.is_unreadable(1)) return call.misused("into sizes that are not constant, or too many");
  auto sizes = call.integers(1, "split");
  if (!sizes && parts >= 1 && parts <= size) {
    const std::int64_t each = (size + parts - 1) / parts;
    sizes.emplace(static_cast<std::size_t>(parts), each);
    sizes->back() = size - each * (parts - 1);
  }
  std::int64_t first = 0;
  for (std::size_t k = 0; sizes && k < sizes->size(); ++k) {
    const std::int64_t count = (*sizes)[k];
    if (count < 1 || count > size - first) break;
    if (k == static_cast<std::size_t>(i)) {
      return picked(call, x, *place, first, count, 1, true);
    }
    first += count;
  }
  return call.misused("into parts that are not there");
}

NetValue split(const NetCall& call) {
  return split_part(call, 0);
}
NetValue later_part(const NetCall& call, const NetValue& /*first*/, int i) {
  return along_time(call, time_of_split, split_part(call, i));
}

}  // namespace

NetValue reordered(const NetCall& call, const NetValue& data, Reorder order, Dims shape) {
  return call.layer_after(data.step, std::move(order), std::move(shape));
}

std::vector<NetOperator> order_operators() {
  return {{"Transpose", transpose, time_of_transpose},
          {"Concat", concat, time_of_concat},
          {"Slice", slice, time_of_slice},
          {"Split", split, time_of_split, {.later = later_part}}};
}

}  // namespace eagerx::gen
