#include "generator/policy/network/graph/tensor.hpp"

#include <fmt/core.h>

#include <cmath>
#include <cstring>

namespace eagerx::gen {
namespace {

double number_at(const NetTensor& tensor, std::size_t index) {
  return value_at(tensor.type, tensor.bytes.data() + index * size_of(tensor.type));
}

std::int64_t integer_at(const NetTensor& tensor, std::size_t index) {
  if (tensor.type == ElementType::boolean) return tensor.bytes[index] != '\0' ? 1 : 0;
  if (tensor.type != ElementType::int64) return static_cast<std::int64_t>(number_at(tensor, index));
  std::int64_t value = 0;  // a double would round it
  std::memcpy(&value, tensor.bytes.data() + index * sizeof value, sizeof value);
  return value;
}

}  // namespace

const NetTensor& made_tensor(std::deque<NetTensor>& all, std::string_view name,
                             const std::vector<float>& numbers, const Dims& dims) {
  NetTensor& made = all.emplace_back();
  made.name = name;
  made.dims = dims;
  made.own.resize(numbers.size() * sizeof(float));
  if (!numbers.empty()) std::memcpy(made.own.data(), numbers.data(), made.own.size());
  made.bytes = made.own;
  return made;
}

std::optional<std::vector<float>> read_floats(const NetConstant& constant, PolicyProblem& problem) {
  const NetTensor& tensor = *constant.tensor;
  if (!is_real(tensor.type)) {
    return refuse(problem, "E0615",
                  fmt::format("computes with tensor `{}` of type {}", printable(tensor.name),
                              *onnx_type_name(onnx_number(tensor.type))),
                  "export the actor in float32");
  }
  const std::vector<double> values = read_numbers(constant);
  if (!all_finite(values, tensor.name, "export", problem)) return std::nullopt;
  return exact_floats(values, tensor.name, "exporting", problem);
}

std::vector<double> read_numbers(const NetConstant& constant) {
  const auto count = static_cast<std::size_t>(element_count(constant.dims).value_or(0));
  const std::size_t columns =
      constant.dims.empty() ? 1 : static_cast<std::size_t>(constant.dims.back());
  const std::size_t rows = columns == 0 ? 0 : count / columns;
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = constant.transposed ? (i % columns) * rows + i / columns : i;
    values[i] = number_at(*constant.tensor, at);
  }
  return values;
}

std::optional<float> infinity_of(const NetConstant& constant) {
  if (!is_real(constant.tensor->type) || element_count(constant.dims) != 1) return std::nullopt;
  const double value = number_at(*constant.tensor, 0);
  return std::isinf(value) ? std::optional(static_cast<float>(value)) : std::nullopt;
}

std::optional<Integers> read_integers(const NetConstant& constant, std::int64_t most) {
  const std::int64_t count = element_count(constant.dims).value_or(kMaxElements);
  if (is_real(constant.tensor->type) || count > most || constant.transposed) return std::nullopt;
  Integers values(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = integer_at(*constant.tensor, i);
  return values;
}

}  // namespace eagerx::gen
