#include "generator/network/graph/tensor.hpp"

#include <fmt/core.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

namespace eagerx::gen {
namespace {

static_assert(std::endian::native == std::endian::little,
              "values are read as they lie in the file");

/// ONNX's types by their numbers; 0 bytes for those that are not read.
struct TypeRow {
  std::string_view name;
  std::size_t bytes = 0;
};
constexpr std::array kTypes = {
    TypeRow{"UNDEFINED"},      TypeRow{"FLOAT", 4},     TypeRow{"UINT8"},
    TypeRow{"INT8"},           TypeRow{"UINT16"},       TypeRow{"INT16"},
    TypeRow{"INT32", 4},       TypeRow{"INT64", 8},     TypeRow{"STRING"},
    TypeRow{"BOOL", 1},        TypeRow{"FLOAT16", 2},   TypeRow{"DOUBLE", 8},
    TypeRow{"UINT32"},         TypeRow{"UINT64"},       TypeRow{"COMPLEX64"},
    TypeRow{"COMPLEX128"},     TypeRow{"BFLOAT16", 2},  TypeRow{"FLOAT8E4M3FN"},
    TypeRow{"FLOAT8E4M3FNUZ"}, TypeRow{"FLOAT8E5M2"},   TypeRow{"FLOAT8E5M2FNUZ"},
};

template <class T>
T element(const NetTensor& tensor, std::size_t index) {
  T value;
  std::memcpy(&value, tensor.bytes.data() + index * sizeof value, sizeof value);
  return value;
}

/// Of a real number; nothing for integers.
std::optional<double> real_at(const NetTensor& tensor, std::size_t index) {
  switch (tensor.type) {
    case NetType::float32:
      return static_cast<double>(element<float>(tensor, index));
    case NetType::float64:
      return element<double>(tensor, index);
    case NetType::float16:
      return half(element<std::uint16_t>(tensor, index));
    case NetType::bfloat16:
      return static_cast<double>(
          std::bit_cast<float>(std::uint32_t{element<std::uint16_t>(tensor, index)} << 16U));
    default:
      return std::nullopt;
  }
}

bool is_real(const NetTensor& tensor) {
  return tensor.type != NetType::int32 && tensor.type != NetType::int64 &&
         tensor.type != NetType::boolean;
}

std::int64_t integer_at(const NetTensor& tensor, std::size_t index) {
  if (tensor.type == NetType::int64) return element<std::int64_t>(tensor, index);
  if (tensor.type == NetType::int32) return element<std::int32_t>(tensor, index);
  return tensor.bytes[index] != '\0' ? 1 : 0;
}

}  // namespace

std::optional<std::string_view> type_name(std::int64_t number) {
  if (number < 0 || number >= static_cast<std::int64_t>(kTypes.size())) return std::nullopt;
  return kTypes.at(static_cast<std::size_t>(number)).name;
}

std::optional<std::size_t> type_bytes(std::int64_t number) {
  if (!type_name(number)) return std::nullopt;
  const std::size_t bytes = kTypes.at(static_cast<std::size_t>(number)).bytes;
  return bytes == 0 ? std::nullopt : std::optional(bytes);
}

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
  const std::string name = printable(tensor.name);
  if (!is_real(tensor)) {
    return refuse(problem, "E0615",
                  fmt::format("computes with tensor `{}` of type {}", name,
                              *type_name(static_cast<std::int64_t>(tensor.type))),
                  "export the actor in float32");
  }
  const auto count = static_cast<std::size_t>(element_count(constant.dims).value_or(0));
  const std::size_t columns =
      constant.dims.empty() ? 1 : static_cast<std::size_t>(constant.dims.back());
  const std::size_t rows = columns == 0 ? 0 : count / columns;
  std::vector<float> values(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t stored = constant.transposed ? (i % columns) * rows + i / columns : i;
    const double value = *real_at(tensor, stored);
    if (!std::isfinite(value)) {
      return refuse(
          problem, "E0616",
          fmt::format("has {} in tensor `{}`", std::isnan(value) ? "NaN" : "infinity", name),
          "the training diverged: export a policy that works");
    }
    // Out of float's range the conversion itself would be undefined.
    const bool fits = std::fabs(value) <= static_cast<double>(std::numeric_limits<float>::max());
    values[i] = fits ? static_cast<float>(value) : 0.0F;
    if (!fits || static_cast<double>(values[i]) != value) {
      return refuse(problem, "E0615",
                    fmt::format("has float64 values in tensor `{}` that float32 cannot hold", name),
                    "convert the actor with `.float()` before exporting it");
    }
  }
  return values;
}

std::optional<float> infinity_of(const NetConstant& constant) {
  if (!is_real(*constant.tensor) || element_count(constant.dims) != 1) return std::nullopt;
  const double value = *real_at(*constant.tensor, 0);
  return std::isinf(value) ? std::optional(static_cast<float>(value)) : std::nullopt;
}

std::optional<Integers> read_integers(const NetConstant& constant, std::int64_t most) {
  const std::int64_t count = element_count(constant.dims).value_or(kMaxElements);
  if (is_real(*constant.tensor) || count > most || constant.transposed) return std::nullopt;
  Integers values(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = integer_at(*constant.tensor, i);
  return values;
}

}  // namespace eagerx::gen
