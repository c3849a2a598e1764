#include "generator/formats/onnx/operators/tensor.hpp"

#include <fmt/core.h>

#include <bit>
#include <cmath>
#include <limits>
#include <string_view>

namespace eagerx::gen {
namespace {

using onnx::TensorProto;

/// Bytes of one element in raw_data; 0 for types that are not read.
std::size_t element_bytes(int type) {
  switch (type) {
    case TensorProto::FLOAT:
    case TensorProto::INT32:
      return sizeof(float);
    case TensorProto::DOUBLE:
    case TensorProto::INT64:
      return sizeof(double);
    case TensorProto::FLOAT16:
    case TensorProto::BFLOAT16:
      return 2;
    case TensorProto::BOOL:
      return 1;
    default:
      return 0;
  }
}

/// Values are in raw_data or in the field of their type; an empty raw_data is none.
bool is_raw(const TensorProto& tensor) {
  return !tensor.raw_data().empty();
}

/// Elements in the typed field that belongs to `tensor`'s type.
std::size_t typed_elements(const TensorProto& tensor) {
  int size = 0;
  switch (tensor.data_type()) {
    case TensorProto::FLOAT:
      size = tensor.float_data_size();
      break;
    case TensorProto::DOUBLE:
      size = tensor.double_data_size();
      break;
    case TensorProto::INT64:
      size = tensor.int64_data_size();
      break;
    default:
      size = tensor.int32_data_size();
      break;
  }
  return static_cast<std::size_t>(size);
}

/// Little-endian bits at element `index` of raw data, whatever this machine is.
template <class Bits>
Bits raw_bits(std::string_view raw, std::size_t index) {
  constexpr unsigned kByte = 8;
  Bits bits = 0;
  for (std::size_t i = 0; i < sizeof(Bits); ++i) {
    bits |= static_cast<Bits>(Bits{static_cast<unsigned char>(raw[index * sizeof(Bits) + i])}
                              << (kByte * i));
  }
  return bits;
}

/// float16 and bfloat16, whose typed field holds their bits in integers.
double short_value_at(const TensorProto& tensor, std::size_t index) {
  const auto bits = is_raw(tensor)
                        ? raw_bits<std::uint16_t>(tensor.raw_data(), index)
                        : static_cast<std::uint16_t>(tensor.int32_data(static_cast<int>(index)));
  if (tensor.data_type() == TensorProto::FLOAT16) return half(bits);
  return static_cast<double>(std::bit_cast<float>(std::uint32_t{bits} << 16U));
}

bool is_short(const TensorProto& tensor) {
  return tensor.data_type() == TensorProto::FLOAT16 || tensor.data_type() == TensorProto::BFLOAT16;
}

double value_at(const TensorProto& tensor, std::size_t index) {
  if (is_short(tensor)) return short_value_at(tensor, index);
  const bool wide = tensor.data_type() == TensorProto::DOUBLE;
  if (is_raw(tensor)) {
    const std::string_view raw = tensor.raw_data();
    return wide ? std::bit_cast<double>(raw_bits<std::uint64_t>(raw, index))
                : static_cast<double>(std::bit_cast<float>(raw_bits<std::uint32_t>(raw, index)));
  }
  const int i = static_cast<int>(index);
  return wide ? tensor.double_data(i) : static_cast<double>(tensor.float_data(i));
}

std::int64_t integer_at(const TensorProto& tensor, std::size_t index) {
  const int type = tensor.data_type();
  if (!is_raw(tensor)) {
    const int i = static_cast<int>(index);
    return type == TensorProto::INT64 ? tensor.int64_data(i) : tensor.int32_data(i);
  }
  const std::string_view raw = tensor.raw_data();
  if (type == TensorProto::INT64) {
    return std::bit_cast<std::int64_t>(raw_bits<std::uint64_t>(raw, index));
  }
  if (type == TensorProto::INT32) {
    return std::bit_cast<std::int32_t>(raw_bits<std::uint32_t>(raw, index));
  }
  return raw[index] != '\0' ? 1 : 0;
}

std::string type_name(int type) {
  return TensorProto::DataType_IsValid(type)
             ? TensorProto::DataType_Name(static_cast<TensorProto::DataType>(type))
             : fmt::format("number {}", type);
}

}  // namespace

std::optional<OnnxConstant> make_constant(const TensorProto& tensor, PolicyProblem& problem) {
  const std::string name = printable(tensor.name());
  const auto fail = [&](const char* code, std::string message, const char* help) {
    problem = {code, std::move(message), help};
    return std::nullopt;
  };
  if (tensor.data_location() == TensorProto::EXTERNAL || tensor.external_data_size() > 0) {
    return fail("E0617", fmt::format("keeps the values of tensor `{}` in another file", name),
                "save it as one file: `onnx.save(model, path, save_as_external_data=False)`");
  }
  const std::size_t bytes = element_bytes(tensor.data_type());
  if (bytes == 0) {
    return fail("E0615",
                fmt::format("has tensor `{}` of type {}", name, type_name(tensor.data_type())),
                "export the actor in float32");
  }
  if (tensor.dims_size() > static_cast<int>(kMaxOnnxRank)) {
    return fail("E0614", fmt::format("has tensor `{}` of {} dimensions", name, tensor.dims_size()),
                kExportAgain);
  }
  OnnxConstant constant{&tensor, Dims(tensor.dims().begin(), tensor.dims().end()), false};
  const std::optional<std::int64_t> count = element_count(constant.dims);
  const std::size_t held =
      is_raw(tensor) ? tensor.raw_data().size() / bytes : typed_elements(tensor);
  const bool whole =
      !is_raw(tensor) || (tensor.raw_data().size() % bytes == 0 && typed_elements(tensor) == 0);
  if (!count || !whole || static_cast<std::uint64_t>(*count) != held) {
    return fail("E0614",
                fmt::format("says that tensor `{}` has shape {}, but holds {} values{}", name,
                            show(constant.dims), held, whole ? "" : " and a rest"),
                kExportAgain);
  }
  return constant;
}

std::optional<std::vector<float>> read_floats(const OnnxConstant& constant,
                                              PolicyProblem& problem) {
  const TensorProto& tensor = *constant.tensor;
  const std::string name = printable(tensor.name());
  if (tensor.data_type() != TensorProto::FLOAT && tensor.data_type() != TensorProto::DOUBLE &&
      !is_short(tensor)) {
    problem = {
        "E0615",
        fmt::format("computes with tensor `{}` of type {}", name, type_name(tensor.data_type())),
        "export the actor in float32"};
    return std::nullopt;
  }
  const auto count = static_cast<std::size_t>(element_count(constant.dims).value_or(0));
  const std::size_t columns =
      constant.dims.empty() ? 1 : static_cast<std::size_t>(constant.dims.back());
  const std::size_t rows = columns == 0 ? 0 : count / columns;
  std::vector<float> values(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t stored = constant.transposed ? (i % columns) * rows + i / columns : i;
    const double value = value_at(tensor, stored);
    if (!std::isfinite(value)) {
      problem = {"E0616",
                 fmt::format("has {} in tensor `{}`", std::isnan(value) ? "NaN" : "infinity", name),
                 "the training diverged: export a policy that works"};
      return std::nullopt;
    }
    // Out of float's range the conversion itself would be undefined.
    const bool fits = std::fabs(value) <= static_cast<double>(std::numeric_limits<float>::max());
    values[i] = fits ? static_cast<float>(value) : 0.0F;
    if (!fits || static_cast<double>(values[i]) != value) {
      problem = {"E0615",
                 fmt::format("has float64 values in tensor `{}` that float32 cannot hold", name),
                 "convert the actor with `.float()` before exporting it"};
      return std::nullopt;
    }
  }
  return values;
}

std::optional<float> infinity_of(const OnnxConstant& constant) {
  const TensorProto& tensor = *constant.tensor;
  const bool is_real = tensor.data_type() == TensorProto::FLOAT ||
                       tensor.data_type() == TensorProto::DOUBLE || is_short(tensor);
  if (!is_real || element_count(constant.dims) != 1) return std::nullopt;
  const double value = value_at(tensor, 0);
  return std::isinf(value) ? std::optional(static_cast<float>(value)) : std::nullopt;
}

std::optional<std::vector<std::int64_t>> read_integers(const OnnxConstant& constant,
                                                       std::int64_t most) {
  const int type = constant.tensor->data_type();
  const std::int64_t count = element_count(constant.dims).value_or(kMaxElements);
  const bool integer =
      type == TensorProto::INT64 || type == TensorProto::INT32 || type == TensorProto::BOOL;
  if (!integer || count > most || constant.transposed) return std::nullopt;
  std::vector<std::int64_t> values(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = integer_at(*constant.tensor, i);
  return values;
}

}  // namespace eagerx::gen
