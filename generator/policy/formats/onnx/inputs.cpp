// Inputs of a graph: observations of a fixed size, and states.
#include "generator/policy/formats/onnx/inputs.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "generator/policy/network/limits.hpp"

namespace eagerx::gen {
namespace {

constexpr std::int64_t kMaxStateLayers = 64;

/// Types that a float32 observation stands for: it holds all numbers of the short integers and
/// of a half, and a double's to its own precision.
bool is_number(int type) {
  return type == onnx::TensorProto::FLOAT || type == onnx::TensorProto::DOUBLE ||
         type == onnx::TensorProto::UINT8 || type == onnx::TensorProto::INT8 ||
         type == onnx::TensorProto::FLOAT16;
}

}  // namespace

std::optional<Dims> input_shape(const onnx::ValueInfoProto& input, bool has_memory,
                                PolicyProblem& problem) {
  const std::string name = printable(input.name());
  const onnx::TypeProto::Tensor& type = input.type().tensor_type();
  const auto fail = [&](const std::string& what) {
    return refuse(problem, "E0608", fmt::format("has input `{}` {}", name, what), kExportActor);
  };
  if (!input.type().has_tensor_type() || !type.has_shape() || type.shape().dim_size() == 0) {
    return fail("of unknown shape");
  }
  if (!is_number(type.elem_type())) {
    const int number = type.elem_type();
    return fail(fmt::format(
        "of type {}",
        onnx::TensorProto::DataType_IsValid(number)
            ? onnx::TensorProto::DataType_Name(static_cast<onnx::TensorProto::DataType>(number))
            : fmt::format("number {}", number)));
  }
  Dims shape;
  const int rank = type.shape().dim_size();
  for (int i = 0; i < rank; ++i) {
    const auto& dim = type.shape().dim(i);
    const bool batch = i == 0 && rank > 1;
    const bool time = has_memory && rank == 3 && i <= 1;
    if ((batch || time) && dim.has_dim_value() && dim.dim_value() > 1) {
      return fail(fmt::format("with a batch of {}: only one observation at a time can be evaluated",
                              dim.dim_value()));
    }
    if (!batch && !time && dim.dim_value() < 1) return fail("of unknown size");
    shape.push_back(batch || time ? 1 : dim.dim_value());
  }
  if (rank > static_cast<int>(kMaxRank) ||
      element_count(shape).value_or(kMaxElements) > kMaxValues) {
    return fail("of an impossible size");
  }
  return shape;
}

bool is_sequence(const onnx::ValueInfoProto& input) {
  const onnx::TensorShapeProto& shape = input.type().tensor_type().shape();
  return shape.dim_size() == 3 && !shape.dim(0).has_dim_value() && !shape.dim(1).has_dim_value();
}

std::optional<NetValue> state_value(const onnx::ValueInfoProto& input, PolicyProblem& problem) {
  const onnx::TensorShapeProto& shape = input.type().tensor_type().shape();
  const auto size = [&](int i) { return shape.dim(i).dim_value(); };
  if (shape.dim_size() < 3) {
    return refuse(problem, "E0608",
                  fmt::format("has a memory and several observations: `{}` is one more, as its "
                              "shape is not that of a state",
                              printable(input.name())),
                  "export the actor with one input for the whole observation, then its states");
  }
  const bool fits = shape.dim_size() == 3 && size(0) >= 1 && size(0) <= kMaxStateLayers &&
                    size(1) <= 1 && size(2) >= 1 && size(2) <= kMaxValues;
  if (!fits) {
    return refuse(problem, "E0608",
                  fmt::format("has input `{}`, which is not a state: [layers, 1, values]",
                              printable(input.name())),
                  "export the actor with the observation first, then its states");
  }
  NetValue value;
  value.kind = NetValue::Kind::state;
  value.shape = Dims{size(0), 1, size(2)};
  value.state.name = input.name();
  value.slots = size(0);
  return value;
}

}  // namespace eagerx::gen
