// Weight files and observations of the commands `policy`.
#pragma once

#include <optional>
#include <string>

#include "generator/driver/commands/policy_options.hpp"
#include "generator/policy/network/golden.hpp"
#include "generator/policy/network/network.hpp"

namespace eagerx::gen {

/// Reads the file with its settings from the command line. Reports one error if it cannot be used.
/// `has_answers`: its answers will be compared with known ones.
std::optional<Network> read_policy_file(const PolicyFile& file, Diagnostics& diagnostics,
                                        bool has_answers = false);

/// Observations without answers, and where they are from.
struct AskedRows {
  GoldenRows rows;
  std::string origin;
};
/// The observations of `--observations`, or `--rows` sampled ones. Reports a problem if `network`
/// cannot evaluate them.
std::optional<AskedRows> asked_rows(const Network& network, const AskedOptions& options,
                                    Diagnostics& diagnostics);

}  // namespace eagerx::gen
