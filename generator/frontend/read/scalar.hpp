// Values of scalars. Strict: one way to write each thing, and no locale.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace eagerx::gen {

/// Decimal integer with an optional sign: "42", "-7", "+1". Nothing for leading zeros (YAML 1.1
/// reads "010" as 8), underscores, hexadecimal, blanks, or a number outside 64 bits.
std::optional<std::int64_t> parse_int(std::string_view text);

/// The same, or a hexadecimal one without sign: "0x0403".
std::optional<std::int64_t> parse_whole(std::string_view text);

/// Number of YAML's core schema (1.2, section 10.3.2) in decimal: "1", "-2.5", ".5", "1.", "6e-3",
/// ".inf", "-.inf", ".nan". Nothing for leading zeros, underscores, or a magnitude outside double.
/// Also multiples of pi: "pi", "-pi/2", "2*pi", "0.75 * pi", "3*pi/4".
std::optional<double> parse_number(std::string_view text);

/// Whether the text is such a number in digits (not .inf or .nan), of any size.
bool is_decimal_text(std::string_view text);

/// "true" or "false" and nothing else: yes, no, on, off, True are not booleans.
std::optional<bool> parse_bool(std::string_view text);

/// "", "~", "null", "Null" or "NULL".
bool is_null_text(std::string_view text);
/// Without the blanks at both ends.
std::string_view trimmed(std::string_view text, std::string_view blanks = " ");

}  // namespace eagerx::gen
