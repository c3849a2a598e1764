// The command lines of programs around a library: LIBRARY, and options from a table.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <runtime/host/base/number.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "targets/environments/client/problem.hpp"
#include "targets/environments/options/row.hpp"

namespace eagerx::client {

using Set = std::function<void(const std::string& text)>;

struct Option {
  options::Row row;
  Set set;
};

/// The effect of the option with this long name.
struct Setter {
  std::string_view name;
  Set set;
};

/// The rows with their setters. Each row must have one setter, and each setter a row; otherwise it
/// is a bug of this program (std::logic_error).
std::vector<Option> options_of(std::span<const options::Row> rows, std::vector<Setter> setters);

struct CommandLine {
  const char* command;  // of eagerx-gen, as "train"
  std::vector<Option> options;
  std::string* library;
  std::function<void()> check;  // of all together, unless an option ended it
};

/// Throws Problem with kUsage.
[[noreturn]] void refuse(const std::string& what);

/// Calls the setters for the words. Throws Problem with kUsage: LIBRARY may be missing, but not
/// repeated.
void parse(const CommandLine& line, int argc, const char* const* argv);

/// A line for each option.
std::string help_of(const std::vector<Option>& options);

/// All of `text` as a number from `low` to `high`, or it throws Problem with kUsage.
template <class T>
T number(std::string_view text, T low, T high) {
  T value{};
  if (host::read_number(text, low, high, value)) return value;
  throw Problem(kUsage, fmt::format("`{}` is not a number from {} to {}", text, low, high));
}

}  // namespace eagerx::client
