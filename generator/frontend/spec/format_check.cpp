// Checks a tree against its table, and explains every problem.
#include <fmt/format.h>

#include <runtime/host/base/renamed.hpp>
#include <set>
#include <utility>

#include "generator/frontend/read/number.hpp"
#include "generator/frontend/read/rational.hpp"
#include "generator/frontend/read/scalar.hpp"
#include "generator/frontend/read/typos.hpp"
#include "generator/frontend/spec/foreign_words.hpp"
#include "generator/frontend/spec/format.hpp"
#include "generator/frontend/spec/format_scalar.hpp"
#include "generator/frontend/spec/misplaced.hpp"
#include "generator/frontend/spec/named.hpp"
#include "generator/frontend/spec/typos.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

Diagnostic& report_missing(const Field& field, Span span, const Format& format,
                           Diagnostics& diagnostics) {
  Diagnostic& problem = diagnostics.error(
      "E0202", span, fmt::format("missing key `{}` in {}", field.name, format.what));
  problem.help = {fmt::format("add `{}:`, {}", field.name, field.about), add_key(field.name)};
  return problem;
}

/// The first key that a record needs and that is not in `yaml`; null: it has all, or is none.
const Field* missing_field(const YamlValue& yaml, const Format& format) {
  if (!yaml.is_map() && !yaml.is_null()) return nullptr;
  const auto missing = ranges::find_if(format.fields, [&](const Field& field) {
    return field.required && yaml.find(field.name) == nullptr;
  });
  return missing == format.fields.end() ? nullptr : &*missing;
}

/// `pendlum: {states: …}` next to `pendulum: {type: …}`, as a variant that mistypes a name makes
/// it.
class Neighbours {
 public:
  Neighbours(const YamlValue& map, const Format& format) : map_(map), format_(format) {}

  /// Whether `entry` has been reported as such.
  bool report(const YamlValue::Entry& entry, Diagnostics& diagnostics) {
    const Field* missing = missing_field(entry.value, *format_.item);
    // Each comparison with all is a scan: for many, it takes a time that grows with their square.
    if (missing == nullptr || ++compared_ > kMostCompared) return false;
    if (compared_ == 1) gather();
    if (nearest(entry.key, whole_).empty()) return false;
    Diagnostic& problem = report_missing(*missing, entry.key_span, *format_.item, diagnostics);
    problem.help = did_you_mean_or(entry.key, whole_, problem.help);
    return true;
  }

 private:
  static constexpr std::size_t kMostCompared = 100;  // more helps are not read

  void gather() {
    for (const auto& other : map_.entries)
      if (other.value.is_map() && missing_field(other.value, *format_.item) == nullptr)
        whole_.push_back(other.key);
  }

  const YamlValue& map_;
  const Format& format_;
  std::vector<std::string> whole_ = {};  // names of entries that miss nothing
  std::size_t compared_ = 0;
};

bool check_map(const YamlValue& yaml, const Format& format, Diagnostics& diagnostics) {
  if (yaml.is_null()) return true;  // `config:` with nothing behind it
  if (!yaml.is_map()) return wrong_type(yaml, format, diagnostics);
  bool good = true;
  Neighbours neighbours(yaml, format);
  for (std::size_t i = 0; i < yaml.entries.size(); ++i) {
    const auto& entry = yaml.entries[i];
    const bool bare = i + 1 < yaml.entries.size() && entry.value.is_null();
    const std::size_t outside =
        bare ? report_not_indented(yaml, i + 1, format, diagnostics) : std::size_t{0};
    if (outside > 0 || report_decimal_comma(yaml.entries, i, diagnostics)) {
      good = false;
      i += outside;
      continue;
    }
    if (neighbours.report(entry, diagnostics)) {
      good = false;
      continue;
    }
    if (format.key)
      good = check(made_scalar(entry.key, entry.key_span), *format.key, diagnostics) && good;
    const bool is_name = format.dotted_names  ? is_dotted_name(entry.key)
                         : format.inner_names ? is_inner_name(entry.key)
                                              : is_identifier(entry.key);
    if (!format.file_names && !is_name) {
      report_bad_name(entry.key, entry.key_span, diagnostics);
      good = false;
    }
    good = check(entry.value, *format.item, diagnostics) && good;
  }
  return good;
}

bool check_list(const YamlValue& yaml, const Format& format, Diagnostics& diagnostics) {
  if (!yaml.is_sequence()) return wrong_type(yaml, format, diagnostics);
  if (yaml.items.size() < format.min_items) {
    diagnostics.error("E0204", yaml.span,
                      fmt::format("expected {}, found an empty list", format.what));
    return false;
  }
  bool good = true;
  for (const auto& item : yaml.items) good = check(item, *format.item, diagnostics) && good;
  return good;
}

/// `theta:` with nothing behind it is a record without settings, where nothing is required.
bool is_empty_record(const YamlValue& yaml, const Format& format) {
  return yaml.is_null() && ranges::none_of(format.fields, &Field::required);
}

/// Reports a former name of a key. Returns the key's name now; empty if it is none.
std::string report_renamed_key(const YamlValue& yaml, const YamlValue::Entry& entry,
                               const Format& format, Diagnostics& diagnostics) {
  std::string now(host::new_name(format.what, entry.key));
  const Field* const field = find_named(format.fields, now);
  if (field == nullptr) return {};
  Diagnostic& problem = diagnostics.error(
      "E0201", entry.key_span, fmt::format("unknown key `{}` in {}", entry.key, format.what));
  if (yaml.find(now) != nullptr) {
    problem.help = fmt::format("leave it out: it is now called `{}`, which is also here", now);
  } else {
    problem.help = {host::help_for_renamed(format.what, entry.key), change_to(now)};
  }
  check(entry.value, *field->format, diagnostics);
  return now;
}

/// Returns the key that was meant; empty if unclear. `reported`: the helps for misplaced keys of
/// the record so far; several that belong to one place are one mistake.
std::string report_unknown_key(const YamlValue& yaml, std::size_t i, const Format& format,
                               const std::vector<std::string>& known,
                               std::set<std::string>& reported, Diagnostics& diagnostics) {
  const YamlValue::Entry& entry = yaml.entries[i];
  if (std::string now = report_renamed_key(yaml, entry, format, diagnostics); !now.empty())
    return now;
  const auto report = [&](Help help) {
    diagnostics
        .error("E0201", entry.key_span,
               fmt::format("unknown key `{}` in {}", entry.key, format.what))
        .help = std::move(help);
  };
  const auto glued = entry.value.is_null() ? glued_key(entry.key) : std::nullopt;
  if (glued && contains(known, glued->key)) {
    report(glued->help);
    return glued->key;
  }
  std::string near = nearest(entry.key, known);
  const std::string outer = outdented_from(yaml, i, format);
  if (!outer.empty()) {
    report(fmt::format("indent it, if it is one of `{}:`", outer));
    return near;
  }
  const std::string misplaced = help_for_misplaced(yaml, i, format, known);
  if (!misplaced.empty()) {
    if (reported.insert(misplaced).second) report(misplaced);
    return {};
  }
  if (near.empty()) near = foreign_word(entry.key, known);
  report(near.empty() ? Help(fmt::format("{} has the keys {}", format.what, join(known, ", ")))
                      : meaning(near));
  return near;
}

bool check_record(const YamlValue& yaml, const Format& format, Diagnostics& diagnostics) {
  if (is_empty_record(yaml, format)) return true;
  if (!yaml.is_map()) return wrong_type(yaml, format, diagnostics);
  bool good = true;
  const std::vector<std::string> known = names_of(format.fields);
  std::vector<std::string> meant;
  std::set<std::string> reported;
  for (std::size_t i = 0; i < yaml.entries.size(); ++i) {
    const auto& entry = yaml.entries[i];
    if (const Field* field = find_named(format.fields, entry.key)) {
      good = check(entry.value, *field->format, diagnostics) && good;
      continue;
    }
    if (format.item) {
      good = check_name(entry.key, entry.key_span, diagnostics) &&
             check(entry.value, *format.item, diagnostics) && good;
      continue;
    }
    good = false;
    if (!report_decimal_comma(yaml.entries, i, diagnostics))
      meant.push_back(report_unknown_key(yaml, i, format, known, reported, diagnostics));
  }
  for (const auto& field : format.fields) {
    if (!field.required || yaml.find(field.name) != nullptr) continue;
    if (contains(meant, field.name)) continue;  // just misspelt
    report_missing(field, yaml.span, format, diagnostics);
    good = false;
  }
  return good;
}

/// Whether a value of this kind could be meant for the format at all.
bool takes(const YamlValue& yaml, const Format& format) {
  switch (format.kind) {
    case Format::Kind::any:
      return true;
    case Format::Kind::list:
      return yaml.is_sequence();
    case Format::Kind::map:
      return yaml.is_map();
    case Format::Kind::record:
      return yaml.is_map() || is_empty_record(yaml, format);
    case Format::Kind::one_of:
      return ranges::any_of(format.options,
                            [&](const FormatPtr& option) { return takes(yaml, *option); });
    case Format::Kind::integer:
      return yaml.is_scalar() && !yaml.quoted && whole_of(yaml);
    case Format::Kind::number:
    case Format::Kind::decimal:
      return yaml.is_scalar() && !yaml.quoted &&
             (real_of(yaml) || exact_of(yaml) || has_unit(yaml, format));
    case Format::Kind::boolean:
      return yaml.is_scalar() && !yaml.quoted && parse_bool(yaml.text);
    default:
      return yaml.is_scalar();
  }
}

}  // namespace

bool check(const YamlValue& yaml, const Format& format, Diagnostics& diagnostics) {
  switch (format.kind) {
    case Format::Kind::any:
      return true;
    case Format::Kind::text:
      return yaml.is_scalar() || wrong_type(yaml, format, diagnostics);
    case Format::Kind::name:
      return check_scalar_name(yaml, format, diagnostics);
    case Format::Kind::port:
      return check_port(yaml, format, diagnostics);
    case Format::Kind::path:
      return check_path(yaml, format, diagnostics);
    case Format::Kind::keyword:
      return check_keyword(yaml, format, "", diagnostics);
    case Format::Kind::boolean:
      return (yaml.is_scalar() && !yaml.quoted && parse_bool(yaml.text)) ||
             wrong_type(yaml, format, diagnostics);
    case Format::Kind::integer:
    case Format::Kind::decimal:
    case Format::Kind::number:
      return check_number(yaml, format, diagnostics);
    case Format::Kind::memory:
      return check_memory(yaml, format, diagnostics);
    case Format::Kind::list:
      return check_list(yaml, format, diagnostics);
    case Format::Kind::map:
      return check_map(yaml, format, diagnostics);
    case Format::Kind::record:
      return check_record(yaml, format, diagnostics);
    case Format::Kind::one_of:
      for (const auto& option : format.options) {
        if (!takes(yaml, *option)) continue;
        const bool is_word = option->kind == Format::Kind::keyword;
        if (is_word && yaml.is_scalar() && !contains(option->keywords, yaml.text) &&
            report_word_for_key(yaml, format, diagnostics))
          return false;
        return is_word ? check_keyword(yaml, *option, format.what, diagnostics)
                       : check(yaml, *option, diagnostics);
      }
      return wrong_type(yaml, format, diagnostics);
  }
  return false;
}

namespace {

void put_in_base_units(YamlValue& yaml, const Format& format) {
  if (format.kind == Format::Kind::one_of) {
    const auto option =
        ranges::find_if(format.options, [&](const FormatPtr& each) { return takes(yaml, *each); });
    if (option != format.options.end()) put_in_base_units(yaml, **option);
    return;
  }
  if (format.quantity != Quantity::none && yaml.is_scalar()) {
    const Unit& base = base_unit(format.quantity);
    if (const auto number = number_in(yaml.text, base)) {
      yaml = made_number(*number, yaml.span);
      yaml.with_unit = true;
    }
  }
  for (auto& item : yaml.items) {
    if (format.item) put_in_base_units(item, *format.item);
  }
  for (auto& [key, span, value] : yaml.entries) {
    const Field* field = find_named(format.fields, key);
    const Format* inner = field != nullptr ? field->format.get() : format.item.get();
    if (inner != nullptr) put_in_base_units(value, *inner);
  }
}

}  // namespace

YamlValue in_base_units(YamlValue yaml, const Format& format) {
  put_in_base_units(yaml, format);
  return yaml;
}

}  // namespace eagerx::gen
