#include "generator/driver/commands/train_settings.hpp"

#include <fmt/format.h>

#include <runtime/host/base/renamed.hpp>

#include "generator/frontend/library/schema.hpp"
#include "generator/frontend/read/scalar.hpp"
#include "generator/frontend/read/tree.hpp"
#include "generator/frontend/spec/format.hpp"
#include "generator/frontend/spec/schema.hpp"
#include "generator/support/command_line/command_line.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "targets/environments/options/train_presets.hpp"
#include "targets/environments/options/train_settings.hpp"

namespace eagerx::gen {
namespace {

using eagerx::options::kTrainSettings;
using SettingRow = eagerx::options::Setting;
using eagerx::options::SettingKind;

std::string value_of(const SettingRow& row) {
  return row.kind == SettingKind::layers ? fmt::format("[{}]", row.otherwise) : row.otherwise;
}

/// "0 to 1", "tanh, relu"
std::string range_of(const SettingRow& row) {
  switch (row.kind) {
    case SettingKind::word:
      return fmt::format("{}", join(comma_separated(row.words), ", "));
    case SettingKind::truth:
      return "true, false";
    case SettingKind::layers:
      return fmt::format("at most {}, each {} to {}", eagerx::options::kMostLayers, row.low,
                         row.high);
    default:
      return fmt::format("{} to {}", row.low, row.high);
  }
}

FormatPtr bounded(const FormatPtr& number, const SettingRow& row) {
  Format copy = *number;
  copy.low = row.low;
  copy.high = row.high;
  return std::make_shared<const Format>(std::move(copy));
}

}  // namespace

FormatPtr setting_format(const SettingRow& row) {
  switch (row.kind) {
    case SettingKind::whole:
      return format::integer("a whole number", row.low, row.high);
    case SettingKind::layers:
      return format::list("a list of widths", format::integer("a width", row.low, row.high), 1);
    case SettingKind::word:
      return format::keyword(comma_separated(row.words));
    case SettingKind::truth:
      return format::boolean();
    case SettingKind::number:
      break;
  }
  return bounded(format::number("a number"), row);
}

const Format& train_settings_format() {
  static const FormatPtr whole = [] {
    std::vector<Field> fields;
    for (const SettingRow& row : kTrainSettings)
      fields.push_back({.name = row.name,
                        .format = setting_format(row),
                        .about = fmt::format("{} (default: {})", row.about, value_of(row))});
    return format::record(std::string(host::kTrainSettings), std::move(fields));
  }();
  return *whole;
}

std::string setting_word(const YamlValue& value) {
  if (value.is_sequence()) {
    std::vector<std::string> words;
    for (const YamlValue& item : value.items) words.push_back(setting_word(item));
    return fmt::format("{}", join(words, ","));
  }
  if (const auto whole = parse_int(value.text)) return fmt::format("{}", *whole);
  if (const auto number = parse_number(value.text)) return fmt::format("{}", *number);
  return value.text;
}

bool check_layers(const YamlValue& layers, Diagnostics& diagnostics) {
  if (layers.items.size() <= eagerx::options::kMostLayers) return true;
  diagnostics.error("E0204", layers.span,
                    fmt::format("expected at most {} layers, found {}",
                                eagerx::options::kMostLayers, layers.items.size()));
  return false;
}

std::optional<std::vector<std::string>> read_train_settings(const std::string& path,
                                                            SourceMap& sources,
                                                            Diagnostics& diagnostics,
                                                            SettingPlaces& places) {
  const YamlValue yaml = read_yaml_file(path, sources, diagnostics);
  if (diagnostics.has_errors() || !check(yaml, train_settings_format(), diagnostics))
    return std::nullopt;
  const YamlValue* layers = yaml.find("layers");
  if (layers != nullptr && !check_layers(*layers, diagnostics)) return std::nullopt;
  std::vector<std::string> words;
  for (const auto& entry : yaml.entries) {
    words.emplace_back("--setting");
    words.push_back(entry.key + "=" + setting_word(entry.value));
    places.add(words.back(), entry.value.span);
  }
  return words;
}

namespace {

std::string presets_text() {
  std::string text =
      "\nPresets, with `--preset NAME`; settings of files and options override them:\n";
  for (const eagerx::options::Preset& preset : eagerx::options::kTrainPresets)
    text += fmt::format("\n  {}, {}\n    {}\n    measured: {}\n    {}\n", preset.name,
                        preset.algorithm, preset.about, preset.measured, preset.values);
  return text;
}

}  // namespace

std::string train_settings_text() {
  std::string text =
      "`eagerx-gen train GRAPH.yaml --settings FILE.yaml`, or one of them with `--setting\n"
      "NAME=VALUE`, which is applied after the file. The checkpoint and the policy file contain\n"
      "all settings. For editors: `eagerx-gen schema --train-settings`. `--sweep FILE.yaml`\n"
      "tries several values: see the README of the trainer. Names are those of\n"
      "Stable-Baselines3 for what means the same there; a line says how it writes a value, or\n"
      "what differs. `eagerx-gen fix FILE.yaml` replaces former names in a file.\n\n";
  for (const SettingRow& row : kTrainSettings) {
    text +=
        fmt::format("{}: {}\n    {}\n    {}{}\n", row.name, value_of(row), row.about, range_of(row),
                    *row.algorithm == '\0' ? "" : fmt::format("; {} only", row.algorithm));
    if (*row.sb3 != '\0') text += fmt::format("    Stable-Baselines3: {}\n", row.sb3);
  }
  return text + presets_text();
}

std::string train_settings_schema() {
  return schema_text(schema_of(train_settings_format()), "eagerx-gen train settings",
                     "eagerx-gen/train-settings.schema.json");
}

}  // namespace eagerx::gen
