// Options of the commands `policy`: weight files, and observations to ask them about.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "generator/driver/commands/arguments.hpp"

namespace eagerx::gen {

/// A weight file, and its settings from the command line.
struct PolicyFile {
  std::string file;  // as the user wrote it
  std::string normalize, activation, output_activation, output_name, actor, layers, input_sizes;
  bool state_dependent_std = false;
};

struct PolicyOptions : MessageOptions {
  PolicyFile policy;
};

/// Observations to evaluate.
struct AskedOptions {
  std::string observations;  // a file; empty: sampled ones
  std::optional<std::uint64_t> rows, seed;
};

/// The options of a weight file.
struct Saying {
  const char* names;
  const char* about;
  const char* type;
  std::string PolicyFile::*member;
  FileUse use = FileUse::none;
};
const std::vector<Saying>& sayings();
inline constexpr const char* kDeviations =
    "ignore the second half of the outputs, which are standard deviations (state_dependent_std of "
    "rsl_rl)";

/// Arguments for a weight file and its settings.
Arguments one_policy(PolicyOptions& options);
Arguments asked(AskedOptions& options);
/// A conflict between them, or "".
std::string check_asked(const AskedOptions& options);

Command policy_info_command();
Command policy_test_command();
/// Writes observations with a policy's answers.
Command policy_golden_command();
/// Compares the answers of two policies.
Command policy_compare_command();

}  // namespace eagerx::gen
