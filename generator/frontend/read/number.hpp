// The number of a value: read from its text or, if it was computed, the number itself without a
// detour through text.
#pragma once

#include <string>

#include "generator/frontend/read/tree.hpp"

namespace eagerx::gen {

/// As messages show it: "20", "0.5", "1/3".
std::string to_string(const ComputedNumber& number);

/// A number that was not in a file, at `span`.
YamlValue made_number(const ComputedNumber& number, Span span);

// nullopt if the value is not such a number. For text in files, parse_int(), parse_number() and
// Rational::parse() decide.
std::optional<std::int64_t> whole_of(const YamlValue& yaml);
std::optional<double> real_of(const YamlValue& yaml);
std::optional<Rational> exact_of(const YamlValue& yaml);

}  // namespace eagerx::gen
