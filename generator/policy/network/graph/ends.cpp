#include "generator/policy/network/graph/ends.hpp"

#include <numeric>
#include <utility>

#include "generator/policy/network/graph/operators.hpp"

namespace eagerx::gen {

NetValue observation_part(NetCall::State& state, const std::string& name, Dims shape) {
  const std::int64_t count = element_count(shape).value_or(0);
  Reorder order;
  order.from.resize(static_cast<std::size_t>(count));
  std::iota(order.from.begin(), order.from.end(), static_cast<std::uint32_t>(state.observed));
  NetValue part = data_value(static_cast<std::int32_t>(state.steps.size()), std::move(shape));
  state.steps.push_back({-1, NetLayer{std::move(order)}, printable(name), count});
  state.observed += count;
  return part;
}

std::optional<NetAction> action_of(const NetValue& value, const char* help,
                                   PolicyProblem& problem) {
  const NetValue result = exact_of(value).value_or(value);
  if (result.kind == NetValue::Kind::data) return NetAction{result.step, false, {}};
  if (result.kind != NetValue::Kind::other) {
    return refuse(problem, "E0620", "has an action that is constant", help);
  }
  if (result.part.role == NetPart::Role::choice)
    return NetAction{result.part.of, true, result.part.groups};
  problem = result.problem;
  return std::nullopt;
}

const NetStateSource* state_before(const std::vector<NetStep>& steps, const NetRemembered& part) {
  const auto* work = std::get_if<NetRecurrence>(&steps[static_cast<std::size_t>(part.step)].what);
  if (work == nullptr) return nullptr;
  const auto& from = part.is_cell ? work->c : work->h;
  return from ? &*from : nullptr;
}

}  // namespace eagerx::gen
