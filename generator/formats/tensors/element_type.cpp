#include "generator/formats/tensors/element_type.hpp"

#include <array>

namespace eagerx::gen {
namespace {

struct ElementNames {
  ElementType type;
  std::size_t size;
  std::string_view numpy, safetensors, torch_storage;
};

/// In the order of ElementType. NumPy has no bfloat16.
constexpr std::array kElements = {
    ElementNames{ElementType::float16, 2, "f2", "F16", "torch.HalfStorage"},
    ElementNames{ElementType::bfloat16, 2, "", "BF16", "torch.BFloat16Storage"},
    ElementNames{ElementType::float32, 4, "f4", "F32", "torch.FloatStorage"},
    ElementNames{ElementType::float64, 8, "f8", "F64", "torch.DoubleStorage"},
    ElementNames{ElementType::int8, 1, "i1", "I8", "torch.CharStorage"},
    ElementNames{ElementType::uint8, 1, "u1", "U8", "torch.ByteStorage"},
    ElementNames{ElementType::int16, 2, "i2", "I16", "torch.ShortStorage"},
    ElementNames{ElementType::int32, 4, "i4", "I32", "torch.IntStorage"},
    ElementNames{ElementType::int64, 8, "i8", "I64", "torch.LongStorage"},
    ElementNames{ElementType::boolean, 1, "b1", "BOOL", "torch.BoolStorage"},
};

std::optional<ElementType> type_called(std::string_view name,
                                       std::string_view ElementNames::*format) {
  for (const ElementNames& element : kElements) {
    if (!name.empty() && element.*format == name) return element.type;
  }
  return std::nullopt;
}

}  // namespace

std::size_t size_of(ElementType type) {
  return kElements.at(static_cast<std::size_t>(type)).size;
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
