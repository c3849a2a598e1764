// torch's operators that shape, pick and reorder.
#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "generator/policy/formats/torchscript/value.hpp"

namespace eagerx::gen {

std::int64_t torch_rank(const NetValue& x) {
  return static_cast<std::int64_t>(x.shape ? x.shape->size() : 0);
}
std::optional<std::int64_t> torch_axis(const NetValue& x, std::optional<std::int64_t> axis) {
  return axis ? place_in(*axis, torch_rank(x)) : std::nullopt;
}

namespace {

using Torch = TorchCall;
using Result = std::optional<NetValue>;

Result transpose(const Torch& call) {
  const auto x = call.tensor(0);
  if (!x || !x->shape) return std::nullopt;
  Integers order(x->shape->size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<std::int64_t>(i);
  const bool matrix = call.name() == "t" || call.name() == "numpy_T";
  const auto a = matrix ? torch_axis(*x, 0) : torch_axis(*x, call.whole(1, "dim0", std::nullopt));
  const auto b = matrix ? torch_axis(*x, -1) : torch_axis(*x, call.whole(2, "dim1", std::nullopt));
  if (!a || !b || (matrix && order.size() > 2)) return std::nullopt;
  std::swap(order[static_cast<std::size_t>(*a)], order[static_cast<std::size_t>(*b)]);
  return call.node("Transpose", {*x}, {{"perm", {}, {}, order}});
}
Result permute(const Torch& call) {
  const auto x = call.tensor(0);
  auto order = call.list(1, "dims");
  if (!x || !order) return std::nullopt;
  for (std::int64_t& axis : *order) axis = axis < 0 ? axis + torch_rank(*x) : axis;
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
  const auto first = x ? torch_axis(*x, call.whole(1, "start_dim", 0)) : std::nullopt;
  const auto last = x ? torch_axis(*x, call.whole(2, "end_dim", -1)) : std::nullopt;
  if (!first || !last || *last < *first) return std::nullopt;
  Integers shape;
  for (std::int64_t i = 0; i < torch_rank(*x); ++i) {
    const std::int64_t size = (*x->shape)[static_cast<std::size_t>(i)];
    if (i > *first && i <= *last) {
      shape.back() *= size;
    } else {
      shape.push_back(size);
    }
  }
  return call.node("Reshape", {*x}, {{"shape", {}, {}, shape}});
}
/// One axis as several.
Result unflatten(const Torch& call) {
  const auto x = call.tensor(0);
  const auto axis = x ? torch_axis(*x, call.whole(1, "dim", std::nullopt)) : std::nullopt;
  const auto sizes = call.list(2, "sizes");
  if (!axis || !sizes) return std::nullopt;
  Integers shape = *x->shape;
  const auto place = shape.begin() + static_cast<std::ptrdiff_t>(*axis);
  shape.insert(shape.erase(place), sizes->begin(), sizes->end());
  return call.node("Reshape", {*x}, {{"shape", {}, {}, shape}});
}
Result squeeze(const Torch& call) {
  auto x = call.tensor(0);
  if (!x) return std::nullopt;
  if (call.argument(1, "dim").is_none()) return call.node("Squeeze", {*x});
  const auto axis = torch_axis(*x, call.whole(1, "dim", std::nullopt));
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

NetValue part(const Torch& call, const NetValue& x, std::int64_t axis, std::int64_t first,
              std::int64_t last, std::int64_t step = 1) {
  return call.node("Slice", {x},
                   {{"starts", {}, {}, Integers{first}},
                    {"ends", {}, {}, Integers{last}},
                    {"axes", {}, {}, Integers{axis}},
                    {"steps", {}, {}, Integers{step}}});
}
Result slice(const Torch& call) {
  const auto x = call.tensor(0);
  const auto axis = x ? torch_axis(*x, call.whole(1, "dim", 0)) : std::nullopt;
  const auto first = call.whole(2, "start", 0);
  const auto last = call.whole(3, "end", std::numeric_limits<std::int64_t>::max());
  const auto step = call.whole(4, "step", 1);
  if (!axis || !first || !last || !step) return std::nullopt;
  return part(call, *x, *axis, *first, *last, *step);
}
Result narrow(const Torch& call) {
  const auto x = call.tensor(0);
  const auto axis = x ? torch_axis(*x, call.whole(1, "dim", std::nullopt)) : std::nullopt;
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
  const auto axis = x ? torch_axis(*x, call.whole(1, "dim", std::nullopt)) : std::nullopt;
  const auto index = call.whole(2, "index", std::nullopt);
  if (!axis || !index) return std::nullopt;
  return call.node("Gather", {*x, integers_value({*index}, {})}, {{"axis", axis}});
}

Result chosen(const Torch& call, const NetValue& x, std::int64_t axis, const NetValue& places) {
  return call.node("Gather", {x, places}, {{"axis", axis}});
}
Result index_select(const Torch& call) {
  const auto x = call.tensor(0);
  const auto axis = x ? torch_axis(*x, call.whole(1, "dim", std::nullopt)) : std::nullopt;
  const auto places = call.tensor(2, "index");
  return axis && places ? chosen(call, *x, *axis, *places) : std::nullopt;
}
/// roll(x, shifts, dims): what leaves at one end of an axis comes in at the other.
Result roll(const Torch& call) {
  const auto x = call.tensor(0);
  const auto shifts = call.list(1, "shifts");
  const auto axes = call.list(2, "dims");
  if (!x || !x->shape || !shifts || !axes || shifts->size() != 1 || axes->size() != 1) {
    return std::nullopt;
  }
  const auto axis = torch_axis(*x, axes->front());
  const std::int64_t size = axis ? (*x->shape)[static_cast<std::size_t>(*axis)] : 0;
  if (size < 1 || !call.state().spend(size)) return std::nullopt;
  Integers from(static_cast<std::size_t>(size));
  const std::int64_t first = (size - shifts->front() % size) % size;
  for (std::int64_t i = 0; i < size; ++i) {
    from[static_cast<std::size_t>(i)] = (first + i) % size;
  }
  return chosen(call, *x, *axis, integers_value(std::move(from), {size}));
}
/// The axis of x[:, places], with `None` for the others.
std::optional<std::size_t> indexed_axis(const std::vector<TorchValue>& by) {
  std::optional<std::size_t> axis;
  for (std::size_t i = 0; i < by.size(); ++i) {
    if (by[i].is_none()) continue;
    if (axis || !by[i].is_tensor()) return std::nullopt;
    axis = i;
  }
  return axis;
}
Result index(const Torch& call) {
  const auto x = call.tensor(0);
  const std::vector<TorchValue>& by = call.argument(1, "indices").items;
  const auto axis = indexed_axis(by);
  if (!x || !axis) return std::nullopt;
  return chosen(call, *x, static_cast<std::int64_t>(*axis), by[*axis].tensor->value);
}
/// `x[places[i]] = values[i]` where x is data: each number of the result comes from x, or from the
/// values that replace it.
Result put_into_data(const Torch& call, const NetValue& x, std::int64_t axis,
                     const NetValue& values, const Integers& places) {
  Integers from(static_cast<std::size_t>((*x.shape)[static_cast<std::size_t>(axis)]));
  std::iota(from.begin(), from.end(), std::int64_t{0});
  const auto size = static_cast<std::int64_t>(from.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    from[static_cast<std::size_t>(places[i])] = size + static_cast<std::int64_t>(i);
  }
  const NetValue both = call.node("Concat", {x, values}, {{"axis", axis}});
  return chosen(call, both, axis, integers_value(std::move(from), {size}));
}
/// The same where x is a row of constants: a matrix of zeros and ones puts the values there, and
/// what is left of x is its bias.
Result put_into_constant(const Torch& call, const NetValue& x, const NetValue& values,
                         const Integers& places) {
  PolicyProblem problem;
  auto rest = read_floats(x.constant, problem);
  if (!rest) return std::nullopt;
  const auto size = static_cast<std::int64_t>(rest->size());
  const auto count = static_cast<std::int64_t>(places.size());
  if (size > kMaxValues / count || !call.state().spend(size * count)) return std::nullopt;
  std::vector<float> matrix(static_cast<std::size_t>(size * count), 0.0F);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto place = static_cast<std::size_t>(places[i]);
    for (std::size_t k = 0; k < i; ++k) matrix[k * rest->size() + place] = 0.0F;  // the last wins
    matrix[i * rest->size() + place] = 1.0F;
    (*rest)[place] = 0.0F;
  }
  const NetValue row =
      call.node("Reshape", {values}, {{"shape", {}, {}, Integers{1, count}}, {"allowzero", 1}});
  const NetValue all =
      call.node("Gemm", {row, call.constant(matrix, {count, size}), call.constant(*rest, {size})});
  return call.node("Reshape", {all}, {{"shape", {}, {}, *x.shape}, {"allowzero", 1}});
}
/// x[:, places] = values: x with these in it.
Result index_put(const Torch& call) {
  const auto x = call.tensor(0);
  const auto values = call.tensor(2, "values");
  const std::vector<TorchValue>& by = call.argument(1, "indices").items;
  const auto axis = indexed_axis(by);
  const TorchValue& adds = call.argument(3, "accumulate");
  if (!x || !x->shape || !values || !axis || *axis >= x->shape->size()) return std::nullopt;
  if (!adds.is_none() && adds.whole() != 0) return std::nullopt;
  const NetValue& where = by[*axis].tensor->value;
  auto places = integers_of(where);
  if (!places || places->empty() || !where.shape || where.shape->size() != 1) return std::nullopt;
  const std::int64_t size = (*x->shape)[*axis];
  for (std::int64_t& place : *places) {
    const auto found = place_in(place, size);
    if (!found) return std::nullopt;
    place = *found;
  }
  Dims shape = *x->shape;
  shape[*axis] = static_cast<std::int64_t>(places->size());
  const NetValue put = call.node("Expand", {*values}, {{"shape", {}, {}, shape}});
  if (x->kind == NetValue::Kind::data) {
    return put_into_data(call, *x, static_cast<std::int64_t>(*axis), put, *places);
  }
  const bool is_row = x->kind == NetValue::Kind::constant && element_count(*x->shape) == size;
  return is_row ? put_into_constant(call, *x, put, *places) : std::nullopt;
}
}  // namespace

std::vector<TorchRow> torch_shape_rows() {
  return {{"t", transpose, true},
          {"numpy_T", transpose, true},
          {"transpose", transpose, true},
          {"permute", permute, true},
          {"reshape", reshape, true},
          {"view", reshape, true},
          {"flatten", flatten, true},
          {"unflatten", unflatten, true},
          {"unsqueeze", torch_of("Unsqueeze", {{0}}, {{TorchGiven::As::list, "axes", {1, "dim"}}}),
           true},
          {"squeeze", squeeze, true},
          {"expand", expand, true},
          {"expand_as", expand, true},
          {"slice", slice, true},
          {"narrow", narrow, true},
          {"select", select, true},
          {"index", index},
          {"index_put", index_put},
          {"index_select", index_select},
          {"roll", roll}};
}

std::optional<TorchValue> torch_parts(const Torch& call) {
  const auto x = call.tensor(0);
  const auto axis = x ? torch_axis(*x, call.whole(2, "dim", 0)) : std::nullopt;
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

}  // namespace eagerx::gen
