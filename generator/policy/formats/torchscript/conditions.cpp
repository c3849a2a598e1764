// torch's operators that compare, and those that pick by the result.

#include "generator/policy/formats/torchscript/value.hpp"

namespace eagerx::gen {
namespace {

using Torch = TorchCall;
using Result = std::optional<NetValue>;

Result not_equal(const Torch& call) {
  const auto same = torch_of_two("Equal")(call);
  return same ? Result(call.node("Not", {*same})) : std::nullopt;
}
Result negation(const Torch& call) {
  const auto x = call.tensor(0);
  // `~` of whole numbers is another thing.
  if (!x || (call.name() == "bitwise_not" && !x->is_condition)) return std::nullopt;
  return call.node("Not", {*x});
}
}  // namespace

std::vector<TorchRow> torch_condition_rows() {
  return {{"gt", torch_of_two("Greater")},
          {"greater", torch_of_two("Greater")},
          {"lt", torch_of_two("Less")},
          {"less", torch_of_two("Less")},
          {"ge", torch_of_two("GreaterOrEqual")},
          {"greater_equal", torch_of_two("GreaterOrEqual")},
          {"le", torch_of_two("LessOrEqual")},
          {"less_equal", torch_of_two("LessOrEqual")},
          {"eq", torch_of_two("Equal")},
          {"ne", not_equal},
          {"not_equal", not_equal},
          {"logical_and", torch_of_two("And")},
          {"__and__", torch_of_two("And")},
          {"bitwise_and", torch_of_two("And")},
          {"logical_or", torch_of_two("Or")},
          {"__or__", torch_of_two("Or")},
          {"bitwise_or", torch_of_two("Or")},
          {"logical_not", negation},
          {"bitwise_not", negation},
          {"sign", torch_of("Sign")},
          {"where", torch_of("Where", {{0}, {1, "self"}, {2, "other"}})},
          {"masked_fill", torch_of("Where", {{1, "mask"}, {2, "value"}, {0}})}};
}

}  // namespace eagerx::gen
