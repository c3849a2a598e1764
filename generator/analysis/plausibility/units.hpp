// Units as manifests write them: `rad/s`, `N*m`, `kg*m^2`.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace eagerx::gen {

/// A product of powers of m, kg, s, A, K, rad, and a scale: 1 deg is 0.0174533 rad.
struct UnitOfMeasure {
  static constexpr std::size_t kBases = 6;
  std::array<std::int8_t, kBases> powers{};
  double scale = 1.0;
};

/// nullopt if the text is empty or not recognized; it is then not checked.
std::optional<UnitOfMeasure> unit_of(std::string_view text);

/// Whether both measure the same quantity, in any scale.
bool same_quantity(const UnitOfMeasure& a, const UnitOfMeasure& b);
/// Whether a number means the same in both.
bool same_scale(const UnitOfMeasure& a, const UnitOfMeasure& b);

}  // namespace eagerx::gen
