#include "generator/policy/network/graph/call.hpp"

#include <fmt/core.h>

#include "generator/policy/network/graph/operators.hpp"
#include "generator/policy/network/limits.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {

const NetValue& NetCall::input(std::size_t i) const {
  static const NetValue kAbsent;
  return i < inputs_.size() ? *inputs_[i] : kAbsent;
}

const NetAttribute* NetCall::attribute(std::string_view name) const {
  const auto found = ranges::find(node_.attributes, name, &NetAttribute::name);
  return found == node_.attributes.end() ? nullptr : &*found;
}

std::int64_t NetCall::integer(std::string_view name, std::int64_t otherwise) const {
  const NetAttribute* found = attribute(name);
  return found != nullptr ? found->whole.value_or(otherwise) : otherwise;
}

float NetCall::real(std::string_view name, float otherwise) const {
  const NetAttribute* found = attribute(name);
  return found != nullptr && found->real ? static_cast<float>(*found->real) : otherwise;
}

std::string_view NetCall::text(std::string_view name) const {
  const NetAttribute* found = attribute(name);
  return found != nullptr ? found->text : std::string_view{};
}

std::optional<Integers> NetCall::integers(std::size_t i, std::string_view name) const {
  if (input(i).kind != NetValue::Kind::absent) return integers_of(input(i));
  const NetAttribute* found = attribute(name);
  return found != nullptr ? std::optional(found->integers()) : std::nullopt;
}

bool NetCall::is_unreadable(std::size_t i) const {
  return input(i).kind != NetValue::Kind::absent && !integers_of(input(i));
}

std::string NetCall::who() const {
  std::string name = fmt::format("operator `{}`", printable(node_.type));
  if (!node_.is_usual()) {
    name += fmt::format(" of `{}`", printable(node_.domain));
  }
  if (!node_.name.empty()) name += fmt::format(" (node `{}`)", printable(node_.name));
  return name;
}

std::optional<Dims> NetCall::common_shape() const {
  std::optional<Dims> shape = Dims{};
  for (const NetValue* input : inputs_) shape = broadcast(shape, input->shape);
  return shape;
}

std::optional<std::size_t> NetCall::axis(std::size_t rank, std::int64_t otherwise) const {
  const auto place = place_in(integer("axis", otherwise), static_cast<std::int64_t>(rank));
  return place ? std::optional(static_cast<std::size_t>(*place)) : std::nullopt;
}

const NetStep* NetCall::step_of(const NetValue& data) const {
  return data.step < 0 ? nullptr : &state_.steps[static_cast<std::size_t>(data.step)];
}

std::int64_t NetCall::count_after(std::int32_t step) const {
  return step < 0 ? state_.observed : state_.steps[static_cast<std::size_t>(step)].count;
}

NetValue NetCall::other(PolicyProblem problem, std::optional<Dims> shape) const {
  NetValue value;
  value.kind = NetValue::Kind::other;
  value.shape = std::move(shape);
  value.problem = std::move(problem);
  for (const NetValue* input : inputs_) {
    if (input->kind != NetValue::Kind::other) continue;
    value.problem = input->problem;
    break;
  }
  return value;
}

NetValue NetCall::misused(const std::string& how, std::optional<Dims> shape) const {
  return other({"E0613", fmt::format("has {} {}", who(), how),
                "export the actor alone: Linear layers with ReLU, Tanh or nothing after them"},
               std::move(shape));
}

NetValue NetCall::too_much() const {
  return other(
      {"E0619", fmt::format("moves too many values before {}", who()), "use a smaller network"});
}

NetValue NetCall::data_after(std::int32_t before, NetWork what, Dims shape) const {
  const std::int64_t count = element_count(shape).value_or(kMaxElements);
  if (count > kMaxValues || count < 1) {
    return other(
        {"E0619",
         fmt::format("has {} values after {}; at most {} are possible", count, who(), kMaxValues),
         "use a smaller network"});
  }
  NetValue value = data_value(static_cast<std::int32_t>(state_.steps.size()), std::move(shape));
  state_.steps.push_back({before, std::move(what), printable(node_.name), count});
  return value;
}

NetValue NetCall::data_of(const std::vector<NetValue>& values, Combination::Operation operation,
                          Dims shape) const {
  Combination combination{operation, {}};
  std::vector<std::int32_t> more;
  for (const NetValue& value : values) {
    const auto count = static_cast<std::uint32_t>(element_count(*value.shape).value_or(0));
    combination.sizes.push_back(count);
    if (combination.sizes.size() > 1) more.push_back(value.step);
  }
  NetValue result = layer_after(values.front().step, std::move(combination), std::move(shape));
  if (result.kind == NetValue::Kind::data) state_.steps.back().more = std::move(more);
  return result;
}

NetValue data_value(std::int32_t step, Dims shape) {
  NetValue value;
  value.kind = NetValue::Kind::data;
  value.step = step;
  value.shape = std::move(shape);
  return value;
}

std::optional<float> scalar_of(const NetValue& value) {
  PolicyProblem ignored;
  if (value.kind != NetValue::Kind::constant || element_count(value.constant.dims) != 1) {
    return std::nullopt;
  }
  const auto numbers = read_floats(value.constant, ignored);
  return numbers ? std::optional(numbers->front()) : std::nullopt;
}

bool is_over_last_axis(const NetCall& call) {
  const NetValue& x = call.input(0);
  const auto axes = call.integers(1, "axes");
  const auto rank = static_cast<std::int64_t>(x.shape ? x.shape->size() : 0);
  return axes && axes->size() == 1 && rank > 0 &&
         (axes->front() == -1 || axes->front() == rank - 1);
}

std::optional<std::vector<std::int64_t>> integers_of(const NetValue& value) {
  if (value.kind == NetValue::Kind::integers) return value.integers;
  if (value.kind == NetValue::Kind::constant) return read_integers(value.constant);
  return std::nullopt;
}

std::optional<Dims> broadcast(const std::optional<Dims>& a, const std::optional<Dims>& b) {
  if (!a || !b) return std::nullopt;
  const Dims& longer = a->size() >= b->size() ? *a : *b;
  const Dims& shorter = a->size() >= b->size() ? *b : *a;
  Dims shape = longer;
  const std::size_t offset = longer.size() - shorter.size();
  for (std::size_t i = 0; i < shorter.size(); ++i) {
    std::int64_t& dim = shape[offset + i];
    if (dim == 1) {
      dim = shorter[i];
    } else if (shorter[i] != 1 && shorter[i] != dim) {
      return std::nullopt;
    }
  }
  if (!element_count(shape)) return std::nullopt;
  return shape;
}

}  // namespace eagerx::gen
