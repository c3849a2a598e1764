#include <array>
#include <charconv>
#include <cmath>
#include <string_view>
#include <targets/linux-sim/elements.hpp>
#include <targets/linux-sim/publish/snapshot.hpp>
#include <type_traits>

namespace eagerx::linux_sim {

Scalar scalar_of_dtype(const char* dtype) {
  struct Named {
    std::string_view name;
    Scalar scalar;
  };
  constexpr std::array kNames{
      Named{"bool", Scalar::boolean}, Named{"int8", Scalar::i8},    Named{"int16", Scalar::i16},
      Named{"int32", Scalar::i32},    Named{"int64", Scalar::i64},  Named{"uint8", Scalar::u8},
      Named{"uint16", Scalar::u16},   Named{"uint32", Scalar::u32}, Named{"uint64", Scalar::u64},
      Named{"float32", Scalar::f32},  Named{"float64", Scalar::f64}};
  for (const Named& each : kNames) {
    if (each.name == dtype) return each.scalar;
  }
  return Scalar::f32;
}

void append_number(std::string& to, const LatestMessage& message, std::size_t i, const char* none) {
  with_elements(
      message.scalar, static_cast<const void*>(message.bytes.data()), [&](const auto* elements) {
        using T = std::remove_cvref_t<decltype(*elements)>;
        constexpr std::size_t kLongest = 32;
        std::array<char, kLongest> text{};
        const auto write = [&](auto value) {
          const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
          to.append(text.data(), end);
        };
        if constexpr (std::is_same_v<T, bool>) {
          to += elements[i] ? '1' : '0';
        } else if constexpr (std::is_floating_point_v<T>) {
          std::isfinite(elements[i]) ? write(elements[i]) : void(to += none);
        } else {
          write(elements[i]);
        }
      });
}

}  // namespace eagerx::linux_sim
