// The file of `eagerx-gen train --sweep`: settings with several values, as the trainer's words.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/driver/commands/setting_places.hpp"
#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

/// Words for the trainer: `--seeds N`, and `--case "NAME=VALUE NAME=VALUE"` for each combination,
/// or for each that was sampled. nullopt and errors of the reader and of the format (E01xx, E02xx)
/// for a file that is wrong. `places` receives the place of each setting.
std::optional<std::vector<std::string>> read_train_sweep(const std::string& path,
                                                         SourceMap& sources,
                                                         Diagnostics& diagnostics,
                                                         SettingPlaces& places);

/// The format of a file of a sweep.
const Format& train_sweep_format();

/// The output of `eagerx-gen schema --train-sweep`.
std::string train_sweep_schema();

}  // namespace eagerx::gen
