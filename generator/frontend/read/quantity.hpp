// Rates and times with a unit, as people write them: "30 Hz", "10ms", "1/3 s".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/frontend/read/rational.hpp"

namespace eagerx::gen {

/// Units of memory are another matter (bytes.hpp): a K is also a kelvin.
enum class Quantity : std::uint8_t { none, rate, time };

/// A unit of rates or times.
struct Unit {
  std::string_view name;
  Quantity quantity = Quantity::none;
  Rational scale;  // how many Hz or s it is
};

/// A text that ends in letters, taken apart. "10 ms" is "10" and "ms"; "30" is "30" and "".
struct NumberAndUnit {
  std::string_view number, unit;
};
NumberAndUnit take_unit_off(std::string_view text);

/// The unit of this name, or nullptr. Case counts: ms is no MS.
const Unit* find_unit(std::string_view name);
/// Names of the units of a quantity, the common ones first.
std::vector<std::string> units_of(Quantity quantity);

/// A number with a unit of `quantity`, or without one, in Hz or s. Nothing for other texts, for
/// another unit, and for what does not fit.
std::optional<Rational> parse_quantity(std::string_view text, Quantity quantity);

/// The text of a number without its unit, in `unit`: "10 ms" in s is "0.01". Nothing for what is no
/// number with a unit of the same quantity. What was written without a unit stays as it is.
std::optional<std::string> number_in(std::string_view text, const Unit& unit);

/// The correction of a number whose unit is wrong: "30 hz" → "30 Hz", a time for a rate
/// "10 ms" → "100 Hz"; empty if there is nothing near.
std::string with_right_unit(std::string_view text, Quantity wanted);

}  // namespace eagerx::gen
