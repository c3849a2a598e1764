// The file of `eagerx-gen train --settings`, by the table that the trainer has, too.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

/// Words for the trainer: `--setting` and `NAME=VALUE` for each that the file names. nullopt and
/// errors of the reader and of the format (E01xx, E02xx) for a file that is wrong.
std::optional<std::vector<std::string>> read_train_settings(const std::string& path,
                                                            SourceMap& sources,
                                                            Diagnostics& diagnostics);

/// What `eagerx-gen help train-settings` says.
std::string train_settings_text();

/// What `eagerx-gen schema --train-settings` prints.
std::string train_settings_schema();

}  // namespace eagerx::gen
