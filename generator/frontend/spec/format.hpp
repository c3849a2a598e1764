// The table of a file's valid contents. The same table checks the file, explains it, and becomes
// the JSON schema for editors.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "generator/frontend/read/quantity.hpp"
#include "generator/frontend/read/tree.hpp"
#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

struct Format;
using FormatPtr = std::shared_ptr<const Format>;

/// One key of a record.
struct Field {
  std::string name;
  FormatPtr format;
  bool required = false;
  std::string about;
};

/// Keys that users misplace in a record, and help that says where they belong: `KEYS` in it is
/// replaced by the keys found.
struct Elsewhere {
  std::vector<std::string> keys;
  std::string help;
};

/// The format of a value.
struct Format {
  enum class Kind : std::uint8_t {
    any,   // checked later, against a manifest
    text,  // any scalar
    name,  // an identifier that is also one in C++
    port,  // names joined by dots, of elements of arrays and of what is inside a composite too
    path,  // names of files and folders, made of letters, digits and `_.+-`
    integer,
    memory,   // bytes, such as 64k
    decimal,  // kept exact; fractions such as 1/3 too
    number,
    boolean,
    keyword,
    list,
    map,     // names chosen by the user
    record,  // names chosen by us
    one_of,  // the first option that takes the kind of value it meets
  };

  Kind kind = Kind::any;
  std::string what;                   // "a rate in Hz", completes "expected …"
  std::vector<std::string> keywords;  // keyword
  FormatPtr item;             // list, map; record: what other keys have, if there may be some
  std::vector<Field> fields;  // record
  std::vector<Elsewhere> elsewhere;  // record: keys that belong elsewhere
  std::vector<FormatPtr> options;    // one_of
  std::optional<double> low;         // integer, decimal, number
  std::optional<double> high;
  bool low_exclusive = false;
  Quantity quantity = Quantity::none;  // decimal, number: may have a unit of it
  std::size_t min_items = 0;           // list
  bool file_names = false;             // map: keys are no identifiers
  bool inner_names = false;            // map: keys may be names within composites: `arm/leg[2]`
  bool dotted_names = false;           // map: keys may be names joined by dots
  FormatPtr key;                       // map: what they are then; without it anything
  bool one_name = false;               // path: no folders
  bool leaves = false;                 // path: `..` is allowed
};

/// The fields of both.
std::vector<Field> with(std::vector<Field> fields, std::vector<Field> more);

namespace format {
FormatPtr any(std::string what);
FormatPtr text(std::string what);
FormatPtr name(std::string what);
FormatPtr port(std::string what);
FormatPtr integer(std::string what, std::optional<double> low = {},
                  std::optional<double> high = {});
FormatPtr decimal(std::string what, double low, bool low_exclusive);
/// A number of bytes, with or without a unit.
FormatPtr memory(std::string what);
FormatPtr rate();
FormatPtr time(std::string what, bool low_exclusive = false);
/// Above 0 and up to 1, with or without `%`.
FormatPtr fraction(std::string what);
FormatPtr number(std::string what, Quantity quantity = Quantity::none);
FormatPtr boolean();
FormatPtr keyword(std::vector<std::string> words);
FormatPtr list(std::string what, FormatPtr item, std::size_t min_items = 0);
FormatPtr map(std::string what, FormatPtr item);
FormatPtr file_map(std::string what);
/// Keys may be names inside composites and arrays, which only `compose/` makes.
FormatPtr inner_map(std::string what, FormatPtr item);
/// The name of a file or folder.
FormatPtr file_name(std::string what);
/// A path of such names; `leaves`: also out of the folder that it begins in.
FormatPtr path(std::string what, bool leaves);
FormatPtr record(std::string what, std::vector<Field> fields);
/// A record that also has keys chosen by the user.
FormatPtr open_record(std::string what, std::vector<Field> fields, FormatPtr others);
FormatPtr one_of(std::string what, std::vector<FormatPtr> options);
}  // namespace format

/// Checks `yaml` against `format`; every problem is reported. True if there was none.
/// Codes: E0201 unknown key, E0202 missing key, E0203 wrong type, E0204 value out of range or not a
/// choice, E0205 not a name, E0209 a wrong unit.
bool check(const YamlValue& yaml, const Format& format, Diagnostics& diagnostics);

/// Converts values with a unit into numbers, in Hz or seconds, in a tree that `check` has accepted.
/// "10 ms" becomes 1/100.
YamlValue in_base_units(YamlValue yaml, const Format& format);

/// The format as JSON schema (draft-07).
std::string json_schema(const Format& format, const std::string& title, const std::string& id);

/// "a list", "nothing", or the text itself: completes "found …".
std::string describe(const YamlValue& yaml);
/// The beginning of a text for a message; whole if it is short.
std::string shortened(std::string_view text);

/// Longest path in a manifest, in bytes.
inline constexpr std::size_t kLongestPath = 255;
/// Longest name in a graph or manifest, in letters.
inline constexpr std::size_t kLongestName = 100;
/// True if `text` is an identifier and no C++ keyword.
bool is_identifier(std::string_view text);
/// True for identifiers with `/` between them, each with or without an index: `arm/leg[2]`.
bool is_inner_name(std::string_view text);
/// Reports text that is not an identifier (E0205). True if it is one.
bool check_name(std::string_view text, Span span, Diagnostics& diagnostics);
/// True if `text` would be an identifier, were it not taken by C++ or by generated code.
bool is_reserved_name(std::string_view text);

}  // namespace eagerx::gen
