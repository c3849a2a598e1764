#include "generator/frontend/spec/misplaced.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "generator/frontend/spec/graph_spec.hpp"
#include "generator/frontend/spec/named.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

/// The record that a value may be, or what each of its names stands for; nullptr if there is none.
const Format* record_in(const Format& format) {
  switch (format.kind) {
    case Format::Kind::record:
      return &format;
    case Format::Kind::map:
      return record_in(*format.item);
    case Format::Kind::one_of:
      for (const FormatPtr& option : format.options) {
        if (const Format* record = record_in(*option)) return record;
      }
      return nullptr;
    default:
      return nullptr;
  }
}

bool has_names(const Format& format) {
  return format.kind == Format::Kind::map ||
         (format.kind == Format::Kind::one_of &&
          ranges::any_of(format.options,
                         [](const FormatPtr& option) { return has_names(*option); }));
}

/// Keys of `record` whose value may have this key.
std::vector<const Field*> above(const std::string& key, const Format& record) {
  std::vector<const Field*> found;
  for (const Field& field : record.fields) {
    const Format* inner = record_in(*field.format);
    if (inner != nullptr && find_named(inner->fields, key) != nullptr) found.push_back(&field);
  }
  return found;
}

/// "low: …, high: …"
std::string settings(const std::vector<std::string>& keys) {
  std::vector<std::string> each;
  each.reserve(keys.size());
  for (const std::string& key : keys) each.push_back(key + ": …");
  return join(each, ", ");
}

/// "`space: {low: …, high: …}`", "`sensors: {NAME: {rate: …}}`"
std::string example(const Field& field, const std::vector<std::string>& keys) {
  const std::string inner = fmt::format("{{{}}}", settings(keys));
  return fmt::format("`{}: {}`", field.name,
                     has_names(*field.format) ? fmt::format("{{NAME: {}}}", inner) : inner);
}

/// Keys of `record`, in their order, that `belong`.
template <class F>
std::vector<std::string> keys_that(const YamlValue& record, F&& belong) {
  std::vector<std::string> keys;
  for (const YamlValue::Entry& entry : record.entries) {
    if (belong(entry.key)) keys.push_back(entry.key);
  }
  return keys;
}

/// `help` with the settings of `record` that are among `keys`.
std::string with_settings(std::string help, const YamlValue& record,
                          const std::vector<std::string>& keys) {
  constexpr std::string_view kPlace = "KEYS";
  const std::size_t at = help.find(kPlace);
  if (at == std::string::npos) return help;
  const auto belong = [&](const std::string& key) { return contains(keys, key); };
  return help.replace(at, kPlace.size(), settings(keys_that(record, belong)));
}

/// Where a type has parameters, a key that is like no other may be one.
std::string help_for_parameters(const YamlValue& record, const Format& format,
                                const std::vector<std::string>& known) {
  const Field* config = find_named(format.fields, "config");
  if (config == nullptr || config->format->kind != Format::Kind::map) return {};
  const auto belong = [&](const std::string& key) {
    return is_identifier(key) && !contains(known, key) && nearest(key, known).empty() &&
           above(key, format).empty();
  };
  return fmt::format("{} has the keys {}; parameters of its type: `config: {{{}}}`", format.what,
                     join(known, ", "), settings(keys_that(record, belong)));
}

}  // namespace

FormatPtr knowing(const FormatPtr& record, std::vector<Elsewhere> elsewhere) {
  Format made = *record;
  made.elsewhere = std::move(elsewhere);
  return std::make_shared<const Format>(std::move(made));
}

Elsewhere of_connections(const std::string& from, const std::string& to) {
  std::vector<std::string> keys = {"processor"};
  for (const Field& field : connection_settings()) keys.push_back(field.name);
  return {std::move(keys),
          fmt::format("it is a setting of a connection: `{{from: {}, to: {}, KEYS}}`", from, to)};
}

Elsewhere rate_of_steps() {
  return {{"rate"}, "actions and observations have the graph's rate, the top-level `rate:`"};
}

std::string help_for_misplaced(const YamlValue& record, std::size_t i, const Format& format,
                               const std::vector<std::string>& known) {
  const std::string& key = record.entries[i].key;
  for (const auto& [keys, help] : format.elsewhere) {
    if (contains(keys, key)) return with_settings(help, record, keys);
  }
  const std::vector<const Field*> fields = above(key, format);
  if (fields.empty())
    return nearest(key, known).empty() ? help_for_parameters(record, format, known) : std::string();
  const std::vector<std::string> together = keys_that(record, [&](const std::string& other) {
    return !contains(known, other) && above(other, format) == fields;
  });
  std::vector<std::string> places;
  places.reserve(fields.size());
  for (const Field* field : fields) places.push_back(example(*field, together));
  return fmt::format("write {}", join(places, " or "));
}

}  // namespace eagerx::gen
