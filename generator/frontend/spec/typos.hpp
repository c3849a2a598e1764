// Typos that YAML turns into a tree: `{kd: 1,5}`, a key that is not indented.
#pragma once

#include <string>
#include <vector>

#include "generator/frontend/spec/format.hpp"

namespace eagerx::gen {

/// Within `{…}` a number ends at its comma, and the rest is a key: `{kd: 1,5}`. Reports this
/// (E0203) if it applies to entry `i`.
bool report_decimal_comma(const std::vector<YamlValue::Entry>& entries, std::size_t i,
                          Diagnostics& diagnostics);

/// The mapping before entry `i` to which the entry would belong if it were indented: `nodes`. Empty
/// if there is none.
std::string outdented_from(const YamlValue& record, std::size_t i, const Format& format);

/// How many entries from `i` on are settings of the one before, which has none: they are not
/// indented. Reports them (E0203); 0 if it is not so.
std::size_t report_not_indented(const YamlValue& map, std::size_t i, const Format& format,
                                Diagnostics& diagnostics);

}  // namespace eagerx::gen
