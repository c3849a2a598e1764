#include "generator/formats/onnx/operators/value.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace eagerx::gen {
namespace {

using Table = std::unordered_map<std::string_view, OnnxOperator>;

std::vector<OnnxOperatorEntry> all_operators() {
  std::vector<OnnxOperatorEntry> all;
  for (const auto& part :
       {layer_operators(), shape_operators(), order_operators(), gather_operators(),
        branch_operators(), elementwise_operators(), image_operators(), recurrent_operators(),
        choice_operators(), condition_operators()}) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

Table make_table() {
  Table table;
  for (const OnnxOperatorEntry& entry : all_operators()) table.emplace(entry.name, entry.run);
  return table;
}

/// Operators whose result has the shape their inputs broadcast to. The action cannot come through
/// them, but its shape may: SAC exports `Expand(mean, Shape(mean + std * noise))`.
bool is_elementwise(std::string_view name) {
  constexpr std::string_view kNames[] = {"Abs",         "Ceil",
                                         "Cos",         "Div",
                                         "Elu",         "Erf",
                                         "Exp",         "Floor",
                                         "HardSigmoid", "Log",
                                         "Max",         "Min",
                                         "Mul",         "Neg",
                                         "LeakyRelu",   "Pow",
                                         "Selu",        "Sigmoid",
                                         "Sin",         "Softmax",
                                         "Sub",         "Sum",
                                         "Softplus",    "Sqrt",
                                         "Softsign",    "RandomNormalLike",
                                         "Round",       "Mod"};
  return std::find(std::begin(kNames), std::end(kNames), name) != std::end(kNames);
}

std::optional<Dims> broadcast_inputs(const OnnxCall& call) {
  std::optional<Dims> shape = Dims{};
  for (std::size_t i = 0; i < call.input_count(); ++i) {
    shape = broadcast(shape, call.input(i).shape);
  }
  return shape;
}

std::string_view advice(std::string_view name) {
  if (name.starts_with("Random") || name == "Multinomial" || name == "Bernoulli") {
    return "export the deterministic action: call the policy with `deterministic=True`";
  }
  return "supported are";
}

OnnxValue unsupported(const OnnxCall& call) {
  const std::string& type = call.node().op_type();
  std::string help(advice(type));
  if (help == "supported are") {
    std::vector<std::string_view> names;
    for (const OnnxOperatorEntry& entry : all_operators()) names.push_back(entry.name);
    std::sort(names.begin(), names.end());
    help = fmt::format("supported are {}", fmt::join(names, ", "));
  }
  return call.other({"E0612", fmt::format("needs {}, which is not supported", call.who()), help},
                    is_elementwise(type) ? broadcast_inputs(call) : std::nullopt);
}

}  // namespace

const OnnxValue& OnnxCall::input(std::size_t i) const {
  static const OnnxValue kAbsent;
  return i < inputs_.size() ? *inputs_[i] : kAbsent;
}

const onnx::AttributeProto* OnnxCall::attribute(std::string_view name) const {
  for (const onnx::AttributeProto& attribute : node_.attribute()) {
    if (attribute.name() == name) return &attribute;
  }
  return nullptr;
}

// Writers of proto3 leave a number out that is zero: the type says that it is meant.
std::int64_t OnnxCall::integer(std::string_view name, std::int64_t otherwise) const {
  const onnx::AttributeProto* found = attribute(name);
  const bool given =
      found != nullptr && (found->has_i() || found->type() == onnx::AttributeProto::INT);
  return given ? found->i() : otherwise;
}

float OnnxCall::real(std::string_view name, float otherwise) const {
  const onnx::AttributeProto* found = attribute(name);
  const bool given =
      found != nullptr && (found->has_f() || found->type() == onnx::AttributeProto::FLOAT);
  return given ? found->f() : otherwise;
}

std::optional<std::vector<std::int64_t>> OnnxCall::integers(std::size_t i,
                                                            std::string_view name) const {
  if (input(i).kind != OnnxValue::Kind::absent) return integers_of(input(i));
  const onnx::AttributeProto* found = attribute(name);
  if (found == nullptr) return std::nullopt;
  return std::vector<std::int64_t>(found->ints().begin(), found->ints().end());
}

bool OnnxCall::is_unreadable(std::size_t i) const {
  return input(i).kind != OnnxValue::Kind::absent && !integers_of(input(i));
}

std::string OnnxCall::who() const {
  std::string name = fmt::format("operator `{}`", printable(node_.op_type()));
  if (!node_.domain().empty() && node_.domain() != "ai.onnx") {
    name += fmt::format(" of `{}`", printable(node_.domain()));
  }
  if (!node_.name().empty()) name += fmt::format(" (node `{}`)", printable(node_.name()));
  return name;
}

OnnxValue OnnxCall::other(PolicyProblem problem, std::optional<Dims> shape) const {
  OnnxValue value;
  value.kind = OnnxValue::Kind::other;
  value.shape = std::move(shape);
  value.problem = std::move(problem);
  for (const OnnxValue* input : inputs_) {
    if (input->kind != OnnxValue::Kind::other) continue;
    value.problem = input->problem;
    break;
  }
  return value;
}

OnnxValue OnnxCall::misused(const std::string& how, std::optional<Dims> shape) const {
  return other({"E0613", fmt::format("has {} {}", who(), how),
                "export the actor alone: Linear layers with ReLU, Tanh or nothing after them"},
               std::move(shape));
}

OnnxValue OnnxCall::too_much() const {
  return other(
      {"E0619", fmt::format("moves too many values before {}", who()), "use a smaller network"});
}

OnnxValue OnnxCall::data_after(std::int32_t before, OnnxWork what, Dims shape) const {
  const std::int64_t count = element_count(shape).value_or(kMaxElements);
  if (count > kMaxValues || count < 1) {
    return other(
        {"E0619",
         fmt::format("has {} values after {}; at most {} are possible", count, who(), kMaxValues),
         "use a smaller network"});
  }
  OnnxValue value;
  value.kind = OnnxValue::Kind::data;
  value.shape = std::move(shape);
  value.step = static_cast<std::int32_t>(state_.steps.size());
  state_.steps.push_back({before, std::move(what), printable(node_.name()), count});
  return value;
}

OnnxValue OnnxCall::data_of(const std::vector<OnnxValue>& values, Combination::Operation operation,
                            Dims shape) const {
  Combination combination{operation, {}};
  std::vector<std::int32_t> more;
  for (const OnnxValue& value : values) {
    const auto count = static_cast<std::uint32_t>(element_count(*value.shape).value_or(0));
    combination.sizes.push_back(count);
    if (combination.sizes.size() > 1) more.push_back(value.step);
  }
  OnnxValue result = data_after(values.front().step, std::move(combination), std::move(shape));
  if (result.kind == OnnxValue::Kind::data) state_.steps.back().more = std::move(more);
  return result;
}

std::optional<float> scalar_of(const OnnxValue& value) {
  PolicyProblem ignored;
  if (value.kind != OnnxValue::Kind::constant || element_count(value.constant.dims) != 1) {
    return std::nullopt;
  }
  const auto numbers = read_floats(value.constant, ignored);
  return numbers ? std::optional(numbers->front()) : std::nullopt;
}

std::optional<std::vector<std::int64_t>> integers_of(const OnnxValue& value) {
  if (value.kind == OnnxValue::Kind::integers) return value.integers;
  if (value.kind == OnnxValue::Kind::constant) return read_integers(value.constant);
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

namespace {

/// The operator's result if what was thought to be a formula was not one.
std::optional<OnnxValue> with_parts(const OnnxCall& call, OnnxOperator run) {
  std::deque<OnnxValue> made;
  std::vector<const OnnxValue*> inputs;
  for (std::size_t i = 0; i < call.input_count(); ++i) {
    inputs.push_back(&call.input(i));
    auto value = materialized(call, call.input(i));
    if (!value) continue;
    made.push_back(std::move(*value));
    inputs.back() = &made.back();
  }
  if (made.empty()) return std::nullopt;
  const OnnxCall again(call.node(), std::move(inputs), call.state());
  OnnxValue value = along_time(again, run(again));
  if (value.kind != OnnxValue::Kind::data) return std::nullopt;
  return value;
}

}  // namespace

OnnxValue evaluate(const OnnxCall& call) {
  static const Table kTable = make_table();
  const std::string& domain = call.node().domain();
  const auto found = kTable.find(call.node().op_type());
  const bool known = domain.empty() || domain == "ai.onnx";
  if (auto value = known ? folded(call) : std::nullopt) return *value;
  if (!known || found == kTable.end()) return unsupported(call);
  OnnxValue value = along_time(call, found->second(call));
  if (value.kind != OnnxValue::Kind::other || value.part.role != OnnxPart::Role::none) return value;
  const auto again = with_parts(call, found->second);
  return again ? *again : value;
}

}  // namespace eagerx::gen
