// Tables of trainings: the curve of `train --csv`, and the results of a sweep (`--results`).
#pragma once

#include <optional>
#include <string_view>

#include "generator/tools/training/lines.hpp"
#include "generator/tools/training/training.hpp"

namespace eagerx::gen {

/// Nothing with a problem, which has been reported. `header`: the first line, which has been read.
std::optional<TrainingRecord> read_curves(std::string_view header, TrainingLines& lines);
std::optional<TrainingRecord> read_sweep(TrainingLines& lines);

/// The first line of a sweep's results.
extern const std::string_view kSweepHeader;

/// Cells of a line; quoted text is one cell, without the quotes.
std::vector<std::string_view> cells_of(std::string_view line);

}  // namespace eagerx::gen
