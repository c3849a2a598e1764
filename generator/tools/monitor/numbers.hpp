// Numbers as a person reads them.
#pragma once

#include <string>

namespace eagerx::gen {

/// All its digits, the fewest that give the same number.
std::string exact_text(double value);
/// At most `columns` characters, at least 8 of which are needed: "-1.2346", "1.23e-07".
std::string short_text(double value, std::size_t columns);
/// Seconds: "2 ms", "1.5 s", "3 min".
std::string duration_text(double seconds);
/// "30", "29.97", "0.5", "1000"
std::string rate_text(double hz);

}  // namespace eagerx::gen
