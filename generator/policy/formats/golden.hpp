// Files of golden rows.
#pragma once

#include <optional>
#include <string>

#include "generator/policy/network/golden.hpp"

namespace eagerx::gen {

/// Reads golden rows: a CSV file with a header (obs0, obs1 …, nobs0 …, network_out, action) or an
/// npz file (obs, obs_normalized, network_out, network_out_f64, action). With a column
/// `episode_start` the rows are sequences: a network's memory goes from row to row up to the
/// next 1. Without it every row starts an episode. E0632.
std::optional<GoldenRows> read_golden(const std::string& path, const std::string& name,
                                      Span mention, Diagnostics& diagnostics);

/// The rows as such a CSV file; `about` is its first line. It is read back with the same numbers.
std::string golden_csv(const GoldenRows& rows, const std::string& about);

}  // namespace eagerx::gen
