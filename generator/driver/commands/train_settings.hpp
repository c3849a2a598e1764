// The file of `eagerx-gen train --settings`, read by the table that the trainer uses, too.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/driver/commands/setting_places.hpp"
#include "generator/frontend/read/tree.hpp"
#include "generator/frontend/spec/format.hpp"
#include "generator/support/diagnostics/diagnostics.hpp"
#include "targets/environments/options/train_settings.hpp"

namespace eagerx::gen {

/// Words for the trainer: `--setting` and `NAME=VALUE` for each that the file names. nullopt and
/// errors of the reader and of the format (E01xx, E02xx) for a file that is wrong. `places`
/// receives the place of each setting.
std::optional<std::vector<std::string>> read_train_settings(const std::string& path,
                                                            SourceMap& sources,
                                                            Diagnostics& diagnostics,
                                                            SettingPlaces& places);

/// The format of a file of settings.
const Format& train_settings_format();
/// The format of a setting's value, but for check_layers().
FormatPtr setting_format(const eagerx::options::Setting& row);
/// Reports a list that is too long (E0204). True if it is not.
bool check_layers(const YamlValue& layers, Diagnostics& diagnostics);
/// A value as the trainer reads it on a command line.
std::string setting_word(const YamlValue& value);

/// The text of `eagerx-gen help train-settings`.
std::string train_settings_text();

/// The output of `eagerx-gen schema --train-settings`.
std::string train_settings_schema();

}  // namespace eagerx::gen
