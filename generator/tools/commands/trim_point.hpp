// The operating point of a graph, as the options of `trim` and `linearize --trim` ask for it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/tools/commands/linear_program.hpp"
#include "generator/tools/commands/trim_question.hpp"
#include "generator/tools/linear/trim_write.hpp"

namespace eagerx::gen {

/// The rows of `--fix`, `--moving` and `--bounds`.
std::vector<Argument> trim_arguments(TrimSettings& settings);

/// The point, found or the nearest to one; nothing with a problem. `image`: of the program.
/// Not found: E0521.
std::optional<TrimReport> trim_point(Run& run, const std::string& image,
                                     const TrimSettings& settings, const LinearOptions& options,
                                     int& code);

/// The options of the program that begin at this point.
std::vector<std::string> words_at(const TrimReport& report);

}  // namespace eagerx::gen
