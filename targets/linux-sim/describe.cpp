#include <algorithm>
#include <array>
#include <bit>
#include <runtime/host/base/number.hpp>
#include <targets/linux-sim/describe.hpp>
#include <targets/linux-sim/elements.hpp>
#include <type_traits>

namespace eagerx::linux_sim {

const char* dtype_name(Scalar scalar) {
  return with_scalar(scalar, [](auto zero) {
    using T = decltype(zero);
    constexpr bool kWide = sizeof(T) > 4;
    if constexpr (std::is_same_v<T, bool>) return "bool";
    if constexpr (std::is_floating_point_v<T>) return kWide ? "float64" : "float32";
    constexpr std::array kSigned{"int8", "int16", "int32", "int64"};
    constexpr std::array kUnsigned{"uint8", "uint16", "uint32", "uint64"};
    constexpr std::size_t kWhich = std::bit_width(sizeof(T)) - 1;
    return std::is_signed_v<T> ? kSigned[kWhich] : kUnsigned[kWhich];
  });
}

namespace {

template <class T>
std::string bound_text(T bound) {
  if constexpr (std::is_floating_point_v<T>) {
    return host::number_text(bound);
  } else {
    return host::number_text(static_cast<std::int64_t>(bound));
  }
}

/// One text if all elements have the same.
std::string bounds_text(const Field& field, const void* bounds) {
  return with_elements(field.type.scalar, bounds, [&](const auto* elements) {
    const std::string first = bound_text(elements[0]);
    std::string all = first;
    bool equal = true;
    for (std::size_t i = 1; i < field.type.size; ++i) {
      const std::string bound = bound_text(elements[i]);
      equal = equal && bound == first;
      all += ", " + bound;
    }
    return equal ? first : "[" + all + "]";
  });
}

std::string line_of(const Field& field) {
  constexpr std::size_t kColumn = 24;
  std::string line = "  " + std::string(field.name);
  line.resize(std::max(line.size() + 1, kColumn), ' ');
  line.append(dtype_name(field.type.scalar)).append(", shape [");
  for (std::size_t i = 0; i < field.type.dimensions; ++i)
    line += (i > 0 ? ", " : "") + std::to_string(field.type.shape[i]);
  line += "]";
  if (field.most > 1)
    line += (field.varies ? ", at most the last " : ", the last ") + std::to_string(field.most);
  if (field.low != nullptr)
    line += ", from " + bounds_text(field, field.low) + " to " + bounds_text(field, field.high);
  return line + "\n";
}

}  // namespace

std::string describe(const Fields& fields) {
  std::string text = "Actions:\n";
  for (const Field& field : fields.actions) text += line_of(field);
  text += "Observations:\n";
  for (const Field& field : fields.observations) text += line_of(field);
  return text;
}

}  // namespace eagerx::linux_sim
