#include <fmt/core.h>

#include <utility>

#include "generator/formats/torchscript/value.hpp"

namespace eagerx::gen {
namespace {

const TorchValue kNoValue;

void set_attribute(onnx::NodeProto& node, const TorchCall::Attribute& attribute) {
  onnx::AttributeProto& made = *node.add_attribute();
  made.set_name(std::string(attribute.name));
  if (attribute.whole) {
    made.set_type(onnx::AttributeProto::INT);
    made.set_i(*attribute.whole);
  } else if (attribute.real) {
    made.set_type(onnx::AttributeProto::FLOAT);
    made.set_f(static_cast<float>(*attribute.real));
  } else if (attribute.list) {
    made.set_type(onnx::AttributeProto::INTS);
    for (const std::int64_t value : *attribute.list) made.add_ints(value);
  } else {
    made.set_type(onnx::AttributeProto::STRING);
    made.set_s(std::string(attribute.text));
  }
}

}  // namespace

const TorchValue& TorchCall::argument(std::size_t i, std::string_view name) const {
  if (i < arguments_.size()) return arguments_[i];
  for (const auto& [known, value] : named_) {
    if (known == name) return value;
  }
  return kNoValue;
}

std::optional<OnnxValue> TorchCall::tensor(std::size_t i, std::string_view name) const {
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

OnnxValue TorchCall::node(const char* type, const std::vector<OnnxValue>& inputs,
                          const std::vector<Attribute>& attributes, int output) const {
  onnx::NodeProto node;
  node.set_op_type(type);
  node.set_name(where_);
  for (int i = 0; i <= output; ++i) node.add_output(fmt::format("{}:{}", name_, i));
  for (const Attribute& attribute : attributes) set_attribute(node, attribute);
  std::vector<const OnnxValue*> given;
  given.reserve(inputs.size());
  for (const OnnxValue& input : inputs) given.push_back(&input);
  const OnnxCall call(node, std::move(given), state_);
  OnnxValue first = evaluate(call);
  return output == 0 ? first : later_output(call, first, output);
}

std::optional<OnnxValue> TorchCall::node_of_two(const char* type) const {
  const auto a = tensor(0);
  const auto b = tensor(1, "other");
  return a && b ? std::optional(node(type, {*a, *b})) : std::nullopt;
}

OnnxValue TorchCall::constant(const std::vector<float>& numbers, const Dims& dims) const {
  onnx::NodeProto node;
  node.set_op_type("Constant");
  node.add_output(std::string(name_));
  return made_constant(OnnxCall(node, {}, state_), numbers, dims);
}

OnnxValue TorchCall::integers(const Integers& values) const {
  return integers_value(values);
}

PolicyProblem TorchCall::misused(const std::string& how) const {
  return {"E0754", fmt::format("calls `{}` {} ({})", printable(name_), how, where_),
          "export the actor alone, or export it to ONNX with `torch.onnx.export`"};
}

}  // namespace eagerx::gen
