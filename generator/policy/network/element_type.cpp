#include "generator/policy/network/element_type.hpp"

#include <fmt/core.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "generator/policy/network/shape.hpp"

namespace eagerx::gen {
namespace {

static_assert(std::endian::native == std::endian::little,
              "values are read as they lie in the file");

template <class T>
T read(const char* from) {
  T value;
  std::memcpy(&value, from, sizeof value);
  return value;
}
template <class T>
double number(const char* from) {
  return static_cast<double>(read<T>(from));
}
double half_number(const char* from) {
  return half(read<std::uint16_t>(from));
}
double bfloat_number(const char* from) {
  return static_cast<double>(std::bit_cast<float>(std::uint32_t{read<std::uint16_t>(from)} << 16U));
}

struct ElementNames {
  ElementType type;
  std::size_t size;
  std::string_view numpy, safetensors, torch_storage;
  std::int64_t onnx;
  double (*value)(const char* from);
};

/// In the order of ElementType. NumPy has no bfloat16.
constexpr std::array kElements = {
    ElementNames{ElementType::float16, 2, "f2", "F16", "torch.HalfStorage", 10, half_number},
    ElementNames{ElementType::bfloat16, 2, "", "BF16", "torch.BFloat16Storage", 16, bfloat_number},
    ElementNames{ElementType::float32, 4, "f4", "F32", "torch.FloatStorage", 1, number<float>},
    ElementNames{ElementType::float64, 8, "f8", "F64", "torch.DoubleStorage", 11, number<double>},
    ElementNames{ElementType::int8, 1, "i1", "I8", "torch.CharStorage", 3, number<std::int8_t>},
    ElementNames{ElementType::uint8, 1, "u1", "U8", "torch.ByteStorage", 2, number<std::uint8_t>},
    ElementNames{ElementType::int16, 2, "i2", "I16", "torch.ShortStorage", 5, number<std::int16_t>},
    ElementNames{ElementType::int32, 4, "i4", "I32", "torch.IntStorage", 6, number<std::int32_t>},
    ElementNames{ElementType::int64, 8, "i8", "I64", "torch.LongStorage", 7, number<std::int64_t>},
    ElementNames{ElementType::boolean, 1, "b1", "BOOL", "torch.BoolStorage", 9,
                 number<std::uint8_t>},
};

std::optional<ElementType> type_called(std::string_view name,
                                       std::string_view ElementNames::*format) {
  for (const ElementNames& element : kElements) {
    if (!name.empty() && element.*format == name) return element.type;
  }
  return std::nullopt;
}

/// In the order of their numbers.
constexpr std::array<std::string_view, 21> kOnnxNames = {
    "UNDEFINED",      "FLOAT",      "UINT8",         "INT8",       "UINT16",   "INT16",
    "INT32",          "INT64",      "STRING",        "BOOL",       "FLOAT16",  "DOUBLE",
    "UINT32",         "UINT64",     "COMPLEX64",     "COMPLEX128", "BFLOAT16", "FLOAT8E4M3FN",
    "FLOAT8E4M3FNUZ", "FLOAT8E5M2", "FLOAT8E5M2FNUZ"};

}  // namespace

std::size_t size_of(ElementType type) {
  return kElements.at(static_cast<std::size_t>(type)).size;
}

bool is_real(ElementType type) {
  return type == ElementType::float16 || type == ElementType::bfloat16 ||
         type == ElementType::float32 || type == ElementType::float64;
}

std::uint64_t little_endian(std::string_view bytes, std::size_t count) {
  std::uint64_t value = 0;
  for (std::size_t i = count; i-- > 0;) value = value << 8U | static_cast<unsigned char>(bytes[i]);
  return value;
}

double value_at(ElementType type, const char* from) {
  return kElements.at(static_cast<std::size_t>(type)).value(from);
}

std::optional<ElementType> onnx_type(std::int64_t number) {
  for (const ElementNames& element : kElements) {
    if (element.onnx == number) return element.type;
  }
  return std::nullopt;
}

std::int64_t onnx_number(ElementType type) {
  return kElements.at(static_cast<std::size_t>(type)).onnx;
}

std::optional<std::string_view> onnx_type_name(std::int64_t number) {
  if (number < 0 || number >= static_cast<std::int64_t>(kOnnxNames.size())) return std::nullopt;
  return kOnnxNames.at(static_cast<std::size_t>(number));
}

bool all_finite(const std::vector<double>& values, std::string_view name, std::string_view verb,
                PolicyProblem& problem) {
  for (const double value : values) {
    if (std::isfinite(value)) continue;
    return refuse(problem, "E0616",
                  fmt::format("has {} in tensor `{}`", std::isnan(value) ? "NaN" : "infinity",
                              printable(name)),
                  fmt::format("the training diverged: {} a policy that works", verb));
  }
  return true;
}

std::optional<std::vector<float>> exact_floats(const std::vector<double>& values,
                                               std::string_view name, std::string_view verb,
                                               PolicyProblem& problem) {
  std::vector<float> result(values.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    // Out of float's range the conversion itself would be undefined.
    const bool fits =
        std::fabs(values[i]) <= static_cast<double>(std::numeric_limits<float>::max());
    result[i] = fits ? static_cast<float>(values[i]) : 0.0F;
    if (fits && static_cast<double>(result[i]) == values[i]) continue;
    return refuse(
        problem, "E0615",
        fmt::format("has float64 values in tensor `{}` that float32 cannot hold", printable(name)),
        fmt::format("convert the actor with `.float()` before {} it", verb));
  }
  return result;
}

std::optional<ElementType> numpy_type(std::string_view code) {
  return type_called(code, &ElementNames::numpy);
}

std::optional<ElementType> safetensors_type(std::string_view name) {
  return type_called(name, &ElementNames::safetensors);
}

std::optional<ElementType> torch_storage_type(std::string_view name) {
  return type_called(name, &ElementNames::torch_storage);
}

}  // namespace eagerx::gen
