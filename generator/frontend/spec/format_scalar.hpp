// Values that are one word, against their format. Inside spec/ only.
#pragma once

#include <string>
#include <string_view>

#include "generator/frontend/spec/format.hpp"

namespace eagerx::gen {

/// Reports a value of the wrong kind (E0204), and returns false.
bool wrong_type(const YamlValue& yaml, const Format& format, Diagnostics& diagnostics);
void report_bad_name(std::string_view text, Span span, Diagnostics& diagnostics);
bool check_scalar_name(const YamlValue& yaml, const Format& format, Diagnostics& diagnostics);
bool check_port(const YamlValue& yaml, const Format& format, Diagnostics& diagnostics);
/// Names of files and ids of targets go into paths, into CMake and into C++.
bool check_path(const YamlValue& yaml, const Format& format, Diagnostics& diagnostics);
/// Reports a word that is a key of a mapping that `format` takes, too (E0204): `gaussian` is
/// `{normal: {…}}`. False: it is none.
bool report_word_for_key(const YamlValue& yaml, const Format& format, Diagnostics& diagnostics);
/// `otherwise`: alternatives to a keyword.
bool check_keyword(const YamlValue& yaml, const Format& format, const std::string& otherwise,
                   Diagnostics& diagnostics);
bool check_number(const YamlValue& yaml, const Format& format, Diagnostics& diagnostics);
bool check_memory(const YamlValue& yaml, const Format& format, Diagnostics& diagnostics);
bool is_dotted_name(std::string_view text);
/// Right or wrong: it is meant as a number with a unit.
bool has_unit(const YamlValue& yaml, const Format& format);

}  // namespace eagerx::gen
