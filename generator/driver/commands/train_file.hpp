// Files of `train --settings` and `--sweep` for commands that take any file: check and fix.
#pragma once

#include <string>

#include "generator/driver/pipeline/pipeline.hpp"

namespace eagerx::gen {

/// Whether the text is such a file: a mapping whose keys are settings, also by former names, or
/// those of a sweep.
bool is_train_file(const std::string& text);

/// The problems of its form. Values that conflict are found by the trainer only.
void check_train_file(Run& run, const std::string& path, const std::string& text);

}  // namespace eagerx::gen
