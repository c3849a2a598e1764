#include "generator/network/graph/evaluate.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <deque>
#include <map>

#include "generator/network/graph/operators.hpp"

namespace eagerx::gen {
namespace {

/// All rows by name.
const std::map<std::string_view, NetOperator>& operators() {
  static const auto kTable = [] {
    std::map<std::string_view, NetOperator> table;
    for (const auto& part :
         {layer_operators(), shape_operators(), order_operators(), gather_operators(),
          branch_operators(), elementwise_operators(), image_operators(), recurrent_operators(),
          choice_operators(), condition_operators()}) {
      for (const NetOperator& row : part) table.emplace(row.name, row);
    }
    return table;
  }();
  return kTable;
}

/// The row of the call; an empty one if there is none.
const NetOperator& row_of(const NetCall& call) {
  static const NetOperator kNone;
  const auto found = operators().find(call.node().type);
  return found == operators().end() ? kNone : found->second;
}

std::optional<Dims> broadcast_inputs(const NetCall& call) {
  std::optional<Dims> shape = Dims{};
  for (std::size_t i = 0; i < call.input_count(); ++i) {
    shape = broadcast(shape, call.input(i).shape);
  }
  return shape;
}

std::string advice(std::string_view name) {
  if (name.starts_with("Random") || name == "Multinomial" || name == "Bernoulli") {
    return "export the deterministic action: call the policy with `deterministic=True`";
  }
  std::vector<std::string_view> names;
  for (const auto& [known, row] : operators()) {
    if (row.run != nullptr) names.push_back(known);
  }
  return fmt::format("supported are {}", fmt::join(names, ", "));
}

NetValue unsupported(const NetCall& call) {
  return call.other({"E0612", fmt::format("needs {}, which is not supported", call.who()),
                     advice(call.node().type)},
                    row_of(call).keeps_shape ? broadcast_inputs(call) : std::nullopt);
}

/// The operator's result if what was thought to be a formula was not one.
std::optional<NetValue> with_parts(const NetCall& call, const NetOperator& row) {
  std::deque<NetValue> made;
  std::vector<const NetValue*> inputs;
  for (std::size_t i = 0; i < call.input_count(); ++i) {
    inputs.push_back(&call.input(i));
    auto value = materialized(call, call.input(i));
    if (!value) continue;
    made.push_back(std::move(*value));
    inputs.back() = &made.back();
  }
  if (made.empty()) return std::nullopt;
  const NetCall again(call.node(), std::move(inputs), call.state());
  NetValue value = along_time(again, row.time, row.run(again));
  if (value.kind != NetValue::Kind::data) return std::nullopt;
  return value;
}

}  // namespace

NetValue evaluate(const NetCall& call) {
  const NetOperator& row = row_of(call);
  const bool known = call.node().is_usual();
  if (auto value = known ? folded(call, row.folding) : std::nullopt) return *value;
  if (!known || row.run == nullptr) return unsupported(call);
  NetValue value = along_time(call, row.time, row.run(call));
  if (value.kind != NetValue::Kind::other || value.part.role != NetPart::Role::none) return value;
  const auto again = with_parts(call, row);
  return again ? *again : value;
}

NetValue later_output(const NetCall& call, const NetValue& first, int i) {
  const auto later = row_of(call).later;
  return later != nullptr ? later(call, first, i) : call.misused("whose second output is used");
}

}  // namespace eagerx::gen
