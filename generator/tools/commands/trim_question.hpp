// What the options of `trim` ask for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/tools/commands/linear_program.hpp"
#include "generator/tools/linear/trim.hpp"

namespace eagerx::gen {

/// What an operating point has to satisfy, as it is written.
struct TrimSettings {
  std::vector<std::string> fix;     // NAME or NAME=VALUE,…
  std::vector<std::string> moving;  // NAME
  std::vector<std::string> bounds;  // NAME=LOW,HIGH
  std::vector<std::string> from;    // ports as inputs; empty: the actions
};

/// "NAME=1,2": the name, and the numbers if there are any.
struct WrittenCondition {
  std::string option, name;
  bool has_numbers = false;
  std::vector<double> numbers;  // empty if they are none
};
/// `--at`, `--fix`, `--moving` and `--bounds`.
std::vector<WrittenCondition> written_options(const TrimSettings& settings,
                                              const LinearOptions& options);

/// "motor.y[2]" -> "motor.y"
std::string without_index(const std::string& name);
/// The channel of a port, or of one of its elements; nothing if it is none.
std::optional<std::size_t> port_named(const std::string& name, const Plan& plan);

/// Checks all names that are known before a program is built: E0521, as a wrong command line.
bool check_trim(const TrimSettings& settings, const LinearOptions& options, const Plan& plan,
                Diagnostics& diagnostics);

/// The question for the program as it is after its first steps. Problems: E0521.
TrimQuestion trim_question(const Hyperperiod& there, const std::vector<WrittenCondition>& options,
                           const Plan& plan, Diagnostics& diagnostics);

}  // namespace eagerx::gen
