#include "generator/policy/network/graph/evaluate.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <deque>
#include <map>

#include "generator/policy/network/graph/operators.hpp"
#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

/// All rows by name.
const std::map<std::string_view, NetOperator>& operators() {
  static const auto kTable = [] {
    std::map<std::string_view, NetOperator> table;
    for (const auto& part :
         {layer_operators(), shape_operators(), order_operators(), gather_operators(),
          branch_operators(), elementwise_operators(), image_operators(), recurrent_operators(),
          choice_operators(), condition_operators(), quantized_operators()}) {
      for (const NetOperator& row : part) table.emplace(row.name, row);
    }
    return table;
  }();
  return kTable;
}

/// The row of an operator; nullptr if there is none.
const NetOperator* row_of(std::string_view type) {
  const auto found = operators().find(type);
  return found == operators().end() ? nullptr : &found->second;
}

std::string advice(std::string_view name) {
  if (name.starts_with("Random") || name == "Multinomial" || name == "Bernoulli") {
    return "export the deterministic action: call the policy with `deterministic=True`";
  }
  if (name.find("uantize") != std::string_view::npos || name.starts_with("QLinear") ||
      name.ends_with("Integer")) {
    return "quantize it with QuantizeLinear and DequantizeLinear (onnxruntime's "
           "`QuantFormat.QDQ`), "
           "or export it before: with `weights: int8` the generator rounds its weights to eight "
           "bits itself";
  }
  std::vector<std::string_view> names;
  for (const auto& [known, row] : operators()) {
    if (row.run != nullptr) names.push_back(known);
  }
  return fmt::format("supported are {}", join(names, ", "));
}

NetValue unsupported(const NetCall& call, const NetOperator* row) {
  const bool has_shape = row != nullptr && row->traits.keeps_shape;
  return call.other({"E0612", fmt::format("needs {}, which is not supported", call.who()),
                     advice(call.node().type)},
                    has_shape ? call.common_shape() : std::nullopt);
}

/// A part of a formula, or what the operator does.
NetValue recognised(const NetCall& call, const NetOperator& row) {
  if (row.traits.formula) {
    if (auto part = part_of_formula(call, *row.traits.formula)) return std::move(*part);
  }
  return row.run(call);
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
  NetValue value = along_time(again, row.time, recognised(again, row));
  if (value.kind != NetValue::Kind::data) return std::nullopt;
  return value;
}

}  // namespace

bool has_weights(std::string_view type) {
  const NetOperator* row = row_of(type);
  return row != nullptr && row->traits.has_weights;
}

bool has_memory(std::string_view type) {
  const NetOperator* row = row_of(type);
  return row != nullptr && row->traits.has_memory;
}

// Fold, recognise, time: operator by operator rather than each over the whole graph, because the
// first problem on the way to the action is the one that is reported.
NetValue evaluate(const NetCall& call) {
  const NetOperator* row = row_of(call.node().type);
  if (row == nullptr || !call.node().is_usual()) return unsupported(call, row);
  if (auto value = folded(call, row->traits.folding)) return *value;
  if (row->run == nullptr) return unsupported(call, row);
  NetValue value = along_time(call, row->time, recognised(call, *row));
  if (value.kind != NetValue::Kind::other || value.part.role != NetPart::Role::none) return value;
  const auto again = with_parts(call, *row);
  return again ? *again : value;
}

NetValue later_output(const NetCall& call, const NetValue& first, int i) {
  const NetOperator* row = row_of(call.node().type);
  if (row == nullptr || row->traits.later == nullptr)
    return call.misused("whose second output is used");
  return row->traits.later(call, first, i);
}

}  // namespace eagerx::gen
