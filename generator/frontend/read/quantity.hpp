// Rates, times, angles, gains and shares with a unit, as people write them: "30 Hz", "10ms",
// "1/3 s", "80 %".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/frontend/read/rational.hpp"

namespace eagerx::gen {

/// Units of memory are another matter (bytes.hpp): a K is also a kelvin.
enum class Quantity : std::uint8_t { none, rate, time, angle, gain, share };

/// A unit of one of them.
struct Unit {
  std::string_view name;
  Quantity quantity = Quantity::none;
  Rational scale;  // how many Hz, s, deg or dB it is; of 1, which has no unit
};
/// The unit of a number without a unit.
const Unit& base_unit(Quantity quantity);

/// A text that ends in letters or `%`, taken apart. "10 ms" is "10" and "ms"; "30" is "30" and "".
struct NumberAndUnit {
  std::string_view number, unit;
};
NumberAndUnit take_unit_off(std::string_view text);

/// The unit of this name, or nullptr. Case counts: ms is no MS.
const Unit* find_unit(std::string_view name);
/// Names of the units of a quantity, the common ones first.
std::vector<std::string> units_of(Quantity quantity);

/// A number with a unit of `quantity`, or without one, in its base unit. nullopt for other text,
/// another unit, and numbers that do not fit.
std::optional<Rational> parse_quantity(std::string_view text, Quantity quantity);

/// A number with a unit, converted to `unit`: "10 ms" in s is 1/100. nullopt if the text is not a
/// number with a unit of the same quantity.
std::optional<Rational> number_in(std::string_view text, const Unit& unit);

/// The correction of a number whose unit is wrong: "30 hz" → "30 Hz", a time for a rate
/// "10 ms" → "100 Hz"; empty if there is nothing near.
std::string with_right_unit(std::string_view text, Quantity wanted);

}  // namespace eagerx::gen
