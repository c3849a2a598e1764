// The record of a training: lines of JSON that `train --record` writes.
#pragma once

#include <optional>

#include "generator/tools/training/lines.hpp"
#include "generator/tools/training/training.hpp"

namespace eagerx::gen {

/// Nothing with a problem, which has been reported.
std::optional<TrainingRecord> read_record(TrainingLines& lines);

}  // namespace eagerx::gen
