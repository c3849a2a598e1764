// torch's operators that compare, and those that pick by the result.
#include <map>

#include "generator/formats/torchscript/value.hpp"

namespace eagerx::gen {
namespace {

using Torch = TorchCall;
using Result = std::optional<NetValue>;

Result greater(const Torch& call) {
  return call.node_of_two("Greater");
}
Result less(const Torch& call) {
  return call.node_of_two("Less");
}
Result greater_or_equal(const Torch& call) {
  return call.node_of_two("GreaterOrEqual");
}
Result less_or_equal(const Torch& call) {
  return call.node_of_two("LessOrEqual");
}
Result equal(const Torch& call) {
  return call.node_of_two("Equal");
}
Result not_equal(const Torch& call) {
  const auto same = equal(call);
  return same ? Result(call.node("Not", {*same})) : std::nullopt;
}
Result conjunction(const Torch& call) {
  return call.node_of_two("And");
}
Result disjunction(const Torch& call) {
  return call.node_of_two("Or");
}
Result negation(const Torch& call) {
  const auto x = call.tensor(0);
  // `~` of whole numbers is another thing.
  if (!x || (call.name() == "bitwise_not" && !x->is_condition)) return std::nullopt;
  return call.node("Not", {*x});
}
Result sign(const Torch& call) {
  const auto x = call.tensor(0);
  return x ? Result(call.node("Sign", {*x})) : std::nullopt;
}
Result where(const Torch& call) {
  const auto condition = call.tensor(0);
  const auto a = call.tensor(1, "self");
  const auto b = call.tensor(2, "other");
  return condition && a && b ? Result(call.node("Where", {*condition, *a, *b})) : std::nullopt;
}
Result masked_fill(const Torch& call) {
  const auto x = call.tensor(0);
  const auto condition = call.tensor(1, "mask");
  const auto value = call.tensor(2, "value");
  return x && condition && value ? Result(call.node("Where", {*condition, *value, *x}))
                                 : std::nullopt;
}

}  // namespace

TorchOperator torch_condition_operator(std::string_view name) {
  static const std::map<std::string_view, TorchOperator> kTable = {
      {"gt", greater},
      {"greater", greater},
      {"lt", less},
      {"less", less},
      {"ge", greater_or_equal},
      {"greater_equal", greater_or_equal},
      {"le", less_or_equal},
      {"less_equal", less_or_equal},
      {"eq", equal},
      {"ne", not_equal},
      {"not_equal", not_equal},
      {"logical_and", conjunction},
      {"__and__", conjunction},
      {"bitwise_and", conjunction},
      {"logical_or", disjunction},
      {"__or__", disjunction},
      {"bitwise_or", disjunction},
      {"logical_not", negation},
      {"bitwise_not", negation},
      {"sign", sign},
      {"where", where},
      {"masked_fill", masked_fill}};
  const auto found = kTable.find(name);
  return found == kTable.end() ? nullptr : found->second;
}

}  // namespace eagerx::gen
