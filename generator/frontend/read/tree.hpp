// YAML text as a tree whose nodes know their places. Nothing outside read/ sees yaml-cpp.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "generator/frontend/read/rational.hpp"
#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

enum class YamlKind : std::uint8_t { null, scalar, sequence, map };

/// The origin of a value. Values in files always have the first: text of a user is never taken for
/// one of the others.
enum class Origin : std::uint8_t {
  written,
  unresolved,  // not known, and already reported: no further message about it
  python,      // an object that only Python knows; its text names it
};

/// The number of an expression, or one that a stage of the generator adds. Whole numbers and
/// decimals are exact if they fit into 64 bits, otherwise doubles.
using ComputedNumber = std::variant<std::int64_t, double, Rational>;

struct Reference;

/// A value and its descendants. Maps keep their order and have no duplicate keys.
struct YamlValue {
  struct Entry;

  YamlKind kind = YamlKind::null;
  Span span;                             // a scalar: its text; a map or sequence: its first token
  std::string tag;                       // explicit tag such as "!!python/tuple" in full
                                         // ("tag:yaml.org,2002:python/tuple"), else empty
  std::string text;                      // scalars; of the next two only for messages
  std::optional<ComputedNumber> number;  // of what was computed, or written with a unit
  std::shared_ptr<const Reference> reference;  // to what a manifest says elsewhere
  Origin origin = Origin::written;
  bool quoted = false;
  bool with_unit = false;        // a rate or time was written with one
  std::vector<YamlValue> items;  // sequences
  std::vector<Entry> entries;    // maps

  [[nodiscard]] bool is_null() const { return kind == YamlKind::null; }
  [[nodiscard]] bool is_scalar() const { return kind == YamlKind::scalar; }
  [[nodiscard]] bool is_sequence() const { return kind == YamlKind::sequence; }
  [[nodiscard]] bool is_map() const { return kind == YamlKind::map; }
  /// The value under `key`, or nullptr.
  [[nodiscard]] const YamlValue* find(std::string_view key) const;
};

struct YamlValue::Entry {
  std::string key;
  Span key_span;
  YamlValue value;
};

/// Values that were not in a file, at `span`.
YamlValue made_scalar(std::string text, Span span);
YamlValue made_list(std::vector<YamlValue> items, Span span);

/// Limits for input; input beyond them causes an error instead of a long wait.
struct ReadLimits {
  std::size_t max_bytes = 16U << 20U;
  std::size_t max_values = 2'000'000;  // aliases expanded
  std::size_t max_depth = 64;
};

/// Reads a YAML file of exactly one document. On a problem adds errors and returns a null value:
/// unreadable or too large file, not UTF-8, control characters, syntax, duplicate key, key that is
/// not a plain scalar, unknown alias, more than one document, too deep, too many values, empty
/// file. `tags`: whether explicit tags are accepted (EAGERx files carry Python's).
enum class Tags : std::uint8_t { refuse, accept };
YamlValue read_yaml_file(const std::string& path, SourceMap& sources, Diagnostics& diagnostics,
                         Tags tags = Tags::refuse, const ReadLimits& limits = {});
/// The first half of it: the file's text is in `sources`; nullopt and an error where it cannot be
/// loaded. One that cannot be read is reported where it is named, at `mention`, as `written`.
std::optional<FileId> load_yaml_file(const std::string& path, SourceMap& sources,
                                     Diagnostics& diagnostics, const ReadLimits& limits = {},
                                     Span mention = {}, const std::string& written = {});
/// The second half, of a file that is loaded.
YamlValue read_loaded_yaml(FileId file, const SourceMap& sources, Diagnostics& diagnostics,
                           Tags tags = Tags::refuse, const ReadLimits& limits = {});
/// The same for text in memory; `name` stands for the file name in messages.
YamlValue read_yaml_text(const std::string& name, std::string text, SourceMap& sources,
                         Diagnostics& diagnostics, Tags tags = Tags::refuse,
                         const ReadLimits& limits = {});

}  // namespace eagerx::gen
