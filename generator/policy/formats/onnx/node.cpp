#include "generator/policy/formats/onnx/node.hpp"

#include <fmt/core.h>

#include <utility>

#include "generator/policy/network/graph/operators.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

using onnx::AttributeProto;
using onnx::TensorProto;

/// The bytes of a typed field.
template <class Field>
std::string_view bytes_of(const Field& field) {
  return {reinterpret_cast<const char*>(field.data()),
          static_cast<std::size_t>(field.size()) * sizeof(*field.data())};
}

/// Short types have a field of wider integers, which are narrowed into `own`.
template <class T>
std::string_view narrowed(const TensorProto& tensor, std::string& own) {
  for (const std::int32_t number : tensor.int32_data()) {
    const auto value = static_cast<T>(number);
    own.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  return own;
}

/// Values that are in the field of their type.
std::string_view typed_bytes(const TensorProto& tensor, std::string& own) {
  switch (tensor.data_type()) {
    case TensorProto::FLOAT:
      return bytes_of(tensor.float_data());
    case TensorProto::DOUBLE:
      return bytes_of(tensor.double_data());
    case TensorProto::INT64:
      return bytes_of(tensor.int64_data());
    case TensorProto::INT32:
      return bytes_of(tensor.int32_data());
    case TensorProto::BOOL:
      return narrowed<bool>(tensor, own);
    case TensorProto::INT8:
      return narrowed<std::int8_t>(tensor, own);
    case TensorProto::UINT8:
      return narrowed<std::uint8_t>(tensor, own);
    default:
      return narrowed<std::uint16_t>(tensor, own);
  }
}

/// nullptr, and a problem, for what is not read.
const NetTensor* checked(const TensorProto& tensor, std::deque<NetTensor>& made,
                         PolicyProblem& problem) {
  const std::string name = printable(tensor.name());
  if (tensor.data_location() == TensorProto::EXTERNAL || tensor.external_data_size() > 0) {
    return refuse(problem, "E0617",
                  fmt::format("keeps the values of tensor `{}` in another file", name),
                  "save it as one file: `onnx.save(model, path, save_as_external_data=False)`");
  }
  const auto type = onnx_type(tensor.data_type());
  if (!type) {
    const auto shown = onnx_type_name(tensor.data_type());
    return refuse(
        problem, "E0615",
        fmt::format("has tensor `{}` of type {}", name,
                    shown ? std::string(*shown) : fmt::format("number {}", tensor.data_type())),
        "export the actor in float32");
  }
  if (tensor.dims_size() > static_cast<int>(kMaxRank)) {
    return refuse(problem, "E0614",
                  fmt::format("has tensor `{}` of {} dimensions", name, tensor.dims_size()),
                  kExportAgain);
  }
  NetTensor& result = made.emplace_back();
  result.name = tensor.name();
  result.type = *type;
  result.dims.assign(tensor.dims().begin(), tensor.dims().end());
  const std::string_view raw = tensor.raw_data();  // an empty one is none
  const std::string_view typed = typed_bytes(tensor, result.own);
  result.bytes = raw.empty() ? typed : raw;
  const auto count = element_count(result.dims);
  const std::size_t size = size_of(*type);
  const std::size_t held = result.bytes.size() / size;
  const bool whole = raw.empty() || (raw.size() % size == 0 && typed.empty());
  if (count && whole && static_cast<std::uint64_t>(*count) == held) return &result;
  return refuse(problem, "E0614",
                fmt::format("says that tensor `{}` has shape {}, but holds {} values{}", name,
                            show(result.dims), held, whole ? "" : " and a rest"),
                kExportAgain);
}

/// Writers of proto3 leave a number out that is zero: the type says that it is meant.
NetAttribute attribute_of(const AttributeProto& attribute, std::deque<NetTensor>& made) {
  NetAttribute result{attribute.name()};
  if (attribute.has_i() || attribute.type() == AttributeProto::INT) result.whole = attribute.i();
  if (attribute.has_f() || attribute.type() == AttributeProto::FLOAT) {
    result.real = static_cast<double>(attribute.f());
  }
  result.list.emplace(attribute.ints().begin(), attribute.ints().end());
  result.text = attribute.s();
  result.texts.assign(attribute.strings().begin(), attribute.strings().end());
  result.reals.assign(attribute.floats().begin(), attribute.floats().end());
  if (attribute.has_t()) result.value = tensor_value(attribute.t(), made);
  return result;
}

/// Converts the forms of older versions of ONNX.
void renew(NetNode& node, std::int64_t opset, std::vector<const NetValue*>& inputs) {
  constexpr std::int64_t kBoundsAreInputs = 11;
  constexpr std::int64_t kSoftmaxHasOneAxis = 13;
  if (node.type == "Clip") {
    if (opset >= kBoundsAreInputs) {
      node.attributes.clear();
    } else if (!inputs.empty()) {
      inputs.resize(1);
    }
  }
  if ((node.type == "Softmax" || node.type == "LogSoftmax") && opset < kSoftmaxHasOneAxis) {
    auto axis = ranges::find(node.attributes, "axis", &NetAttribute::name);
    if (axis == node.attributes.end()) {
      axis = node.attributes.insert(axis, NetAttribute{"axis"});
    }
    if (!axis->whole) axis->whole = 1;
    node.attributes.push_back({kSoftmaxToLast, 1});
  }
}

}  // namespace

NetValue tensor_value(const TensorProto& tensor, std::deque<NetTensor>& made) {
  NetValue value;
  if (const NetTensor* found = checked(tensor, made, value.problem)) return constant_value(*found);
  value.kind = NetValue::Kind::other;
  return value;
}

NetNode node_of(const onnx::NodeProto& node, std::int64_t opset,
                std::vector<const NetValue*>& inputs, std::deque<NetTensor>& made) {
  NetNode result{node.op_type(), node.name(), node.domain()};
  if (node.output_size() > 0) result.output = node.output(0);
  result.outputs = node.output_size();
  for (const AttributeProto& attribute : node.attribute()) {
    result.attributes.push_back(attribute_of(attribute, made));
  }
  renew(result, opset, inputs);
  return result;
}

}  // namespace eagerx::gen
