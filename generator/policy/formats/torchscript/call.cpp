#include <fmt/core.h>

#include <utility>

#include "generator/policy/formats/torchscript/value.hpp"
#include "generator/policy/network/graph/evaluate.hpp"

namespace eagerx::gen {
namespace {

const TorchValue kNoValue;

}  // namespace

const TorchValue& TorchCall::argument(std::size_t i, std::string_view name) const {
  if (i < arguments_.size()) return arguments_[i];
  for (const auto& [known, value] : named_) {
    if (known == name) return value;
  }
  return kNoValue;
}

std::optional<NetValue> TorchCall::tensor(std::size_t i, std::string_view name) const {
  const TorchValue& value = argument(i, name);
  if (value.is_tensor()) return value.tensor->value;
  const auto number = value.number();
  if (!number) return std::nullopt;
  return constant({static_cast<float>(*number)}, {});
}

std::optional<std::int64_t> TorchCall::whole(std::size_t i, std::string_view name,
                                             std::optional<std::int64_t> otherwise) const {
  const TorchValue& value = argument(i, name);
  return value.is_none() ? otherwise : value.whole();
}

std::optional<double> TorchCall::number(std::size_t i, std::string_view name,
                                        std::optional<double> otherwise) const {
  const TorchValue& value = argument(i, name);
  if (value.is_tensor()) {
    const auto scalar = scalar_of(value.tensor->value);
    return scalar ? std::optional(static_cast<double>(*scalar)) : std::nullopt;
  }
  return value.is_none() ? otherwise : value.number();
}

std::optional<Integers> TorchCall::list(std::size_t i, std::string_view name) const {
  const TorchValue& value = argument(i, name);
  if (const auto one = value.whole()) return Integers{*one};
  if (value.kind != TorchValue::Kind::sequence) return std::nullopt;
  Integers result;
  for (const TorchValue& item : value.items) {
    const auto whole = item.whole();
    if (!whole) return std::nullopt;
    result.push_back(*whole);
  }
  return result;
}

NetValue TorchCall::node(const char* type, const std::vector<NetValue>& inputs,
                         std::vector<NetAttribute> attributes) const {
  const std::string result = fmt::format("{}:0", name_);
  const NetNode node{type, where_, {}, result, 1, std::move(attributes)};
  std::vector<const NetValue*> given;
  given.reserve(inputs.size());
  for (const NetValue& input : inputs) given.push_back(&input);
  return evaluate(NetCall(node, std::move(given), state_));
}

NetValue TorchCall::constant(const std::vector<float>& numbers, const Dims& dims) const {
  return constant_value(made_tensor(state_.made, name_, numbers, dims));
}

PolicyProblem TorchCall::misused(const std::string& how) const {
  return {"E0754", fmt::format("calls `{}` {} ({})", printable(name_), how, where_),
          "export the actor alone, or export it to ONNX with `torch.onnx.export`"};
}

namespace {

/// The attribute as the call has it; nothing if it is not there, or not what it must be.
std::optional<NetAttribute> attribute_of(const TorchCall& call, const TorchGiven& given) {
  using As = TorchGiven::As;
  const auto& [at, name] = given.argument;
  const auto whole =
      given.otherwise ? std::optional(static_cast<std::int64_t>(*given.otherwise)) : std::nullopt;
  NetAttribute made{given.attribute};
  if (given.as == As::list) {
    made.list = call.list(at, name);
  } else if (given.as == As::number) {
    made.real = call.number(at, name, given.otherwise);
  } else {
    made.whole = call.whole(at, name, whole);
  }
  const bool is_there = made.list || made.real || made.whole;
  const bool is_fixed = given.attribute.empty();
  const bool is_usual = made.real ? made.real == given.otherwise : made.whole == whole;
  return is_there && (!is_fixed || is_usual) ? std::optional(made) : std::nullopt;
}

}  // namespace

TorchRun torch_of(const char* type, std::vector<TorchArgument> tensors,
                  std::vector<TorchGiven> given) {
  return [type, tensors = std::move(tensors),
          given = std::move(given)](const TorchCall& call) -> std::optional<NetValue> {
    std::vector<NetValue> inputs;
    for (const auto& [at, name] : tensors) {
      auto x = call.tensor(at, name);
      if (!x) return std::nullopt;
      inputs.push_back(std::move(*x));
    }
    std::vector<NetAttribute> attributes;
    for (const TorchGiven& each : given) {
      auto attribute = attribute_of(call, each);
      if (!attribute) return std::nullopt;
      if (!each.attribute.empty()) attributes.push_back(std::move(*attribute));
    }
    return call.node(type, inputs, std::move(attributes));
  };
}

TorchRun torch_of_two(const char* type) {
  return torch_of(type, {{0}, {1, "other"}});
}

}  // namespace eagerx::gen
