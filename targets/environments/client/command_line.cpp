#include "targets/environments/client/command_line.hpp"

#include <algorithm>
#include <runtime/host/base/renamed.hpp>
#include <stdexcept>
#include <utility>

namespace eagerx::client {
namespace {

/// "--output" of "-o,--output"
std::string_view long_name(const Option& option) {
  const std::string_view names = option.row.names;
  return names.substr(names.find(',') + 1);
}

bool is_called(const Option& option, std::string_view word) {
  const std::string_view names = option.row.names;
  return word == long_name(option) || word == names.substr(0, names.find(','));
}

/// Whether something is left to look at. `i` is where the word stands.
bool take(const CommandLine& line, int argc, const char* const* argv, int& i) {
  const std::string word = argv[i];
  if (!word.starts_with('-')) {
    if (!line.library->empty()) refuse("there is one LIBRARY only, `" + word + "` is another");
    *line.library = word;
    return true;
  }
  const std::size_t equals = word.starts_with("--") ? word.find('=') : std::string::npos;
  const std::string name = word.substr(0, equals);
  const auto option = std::ranges::find_if(
      line.options, [&](const Option& other) { return is_called(other, name); });
  if (option == line.options.end())
    throw Problem(kUsage, "there is no option `" + word + "`",
                  host::help_for_renamed(std::string("options of ") + line.command, name));
  const bool has_value = equals != std::string::npos;
  if (*option->row.value == '\0') {
    if (has_value) refuse("`" + name + "` takes no value");
    option->set({});
    return !option->row.ends;
  }
  // A word that begins with two dashes is the next option; write such a value as
  // `--option=--value`.
  if (!has_value && (i + 1 == argc || std::string_view(argv[i + 1]).starts_with("--")))
    refuse("`" + word + "` needs a value");
  try {
    option->set(has_value ? word.substr(equals + 1) : std::string(argv[++i]));
  } catch (const Problem& problem) {
    throw Problem(problem.code, name + ": " + problem.what(), problem.help);
  }
  return true;
}

}  // namespace

void refuse(const std::string& what) {
  throw Problem(kUsage, what);
}

std::vector<Option> options_of(std::span<const options::Row> rows, std::vector<Setter> setters) {
  std::vector<Option> result;
  for (const options::Row& row : rows) {
    Option option{row, {}};
    const auto found = std::ranges::find(setters, long_name(option), &Setter::name);
    if (found == setters.end()) throw std::logic_error(row.names);
    option.set = std::move(found->set);
    setters.erase(found);
    result.push_back(std::move(option));
  }
  if (!setters.empty()) throw std::logic_error(std::string(setters.front().name));
  return result;
}

void parse(const CommandLine& line, int argc, const char* const* argv) {
  try {
    for (int i = 1; i < argc; ++i) {
      if (!take(line, argc, argv, i)) return;
    }
    line.check();
  } catch (const Problem& problem) {
    if (!problem.help.empty()) throw;
    throw Problem(problem.code, problem.what(),
                  std::string("`eagerx-gen ") + line.command + " --help` lists the options");
  }
}

std::string help_of(const std::vector<Option>& options) {
  std::size_t column = 0;
  const auto name_of = [](const Option& option) {
    std::string names = option.row.names;
    if (const std::size_t comma = names.find(','); comma != std::string::npos)
      names.insert(comma + 1, " ");
    return "  " + names + (*option.row.value == '\0' ? "" : " ") + option.row.value;
  };
  for (const Option& option : options) column = std::max(column, name_of(option).size() + 2);
  std::string text;
  for (const Option& option : options) {
    std::string name = name_of(option);
    name.resize(column, ' ');
    text += name + option.row.about + "\n";
  }
  return text;
}

}  // namespace eagerx::client
