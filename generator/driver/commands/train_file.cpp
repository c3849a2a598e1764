#include "generator/driver/commands/train_file.hpp"

#include <runtime/host/base/renamed.hpp>

#include "generator/driver/commands/train_settings.hpp"
#include "generator/driver/commands/train_sweep.hpp"
#include "generator/frontend/spec/named.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

bool has_key(const Format& format, const std::string& key) {
  return find_named(format.fields, key) != nullptr || !host::new_name(format.what, key).empty();
}

/// The format that has all keys of the file; nullptr: neither has.
const Format* format_of(const YamlValue& yaml) {
  if (!yaml.is_map() || yaml.entries.empty()) return nullptr;
  for (const Format* format : {&train_settings_format(), &train_sweep_format()}) {
    const auto is_known = [&](const YamlValue::Entry& entry) {
      return has_key(*format, entry.key);
    };
    if (ranges::all_of(yaml.entries, is_known)) return format;
  }
  return nullptr;
}

}  // namespace

bool is_train_file(const std::string& text) {
  SourceMap sources;
  Diagnostics ignored;
  return format_of(read_yaml_text("", text, sources, ignored)) != nullptr;
}

void check_train_file(Run& run, const std::string& path, const std::string& text) {
  const YamlValue yaml = read_yaml_text(path, text, run.sources, run.diagnostics);
  const Format* const format = format_of(yaml);
  if (format != nullptr) check(yaml, *format, run.diagnostics);
}

}  // namespace eagerx::gen
