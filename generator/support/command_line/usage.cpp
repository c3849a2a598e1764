#include "generator/support/command_line/usage.hpp"

#include <fmt/format.h>

#include <cctype>
#include <filesystem>
#include <runtime/host/base/renamed.hpp>

#include "generator/support/diagnostics/diagnostics.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

std::string message(const std::string& error, const Help& help) {
  return fmt::format("error: {}\n{}", error,
                     help.empty() ? "" : fmt::format("help: {}\n", help.text));
}

/// The command that the arguments had got to, and what was typed to get there.
const CLI::App* command_reached(const CLI::App& app, std::string& typed) {
  const CLI::App* reached = &app;
  typed = app.get_name();
  while (!reached->get_subcommands().empty()) {
    reached = reached->get_subcommands().front();
    typed += " " + reached->get_name();
  }
  return reached;
}

std::vector<std::string> names_of_commands(const CLI::App& app) {
  std::vector<std::string> names;
  // A hidden one is in no group.
  for (const CLI::App* each :
       app.get_subcommands([](const CLI::App* one) { return !one->get_group().empty(); }))
    names.push_back(each->get_name());
  return names;
}

std::vector<std::string> names_of_options(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const auto& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

std::string too_much(const CLI::App& reached, const std::string& typed,
                     const std::string& otherwise) {
  const std::vector<std::string> rest = reached.remaining(true);
  if (rest.empty()) return message("too many arguments", otherwise);
  // An option that is not known leaves its value behind, too.
  const auto option = ranges::find_if(
      rest, [](const std::string& each) { return each.size() > 1 && each.front() == '-'; });
  const std::string& first = option == rest.end() ? rest.front() : *option;
  const std::string word = first.substr(0, first.find('='));
  if (!word.starts_with('-'))
    return message(fmt::format("`{}` is one argument too many for `{}`", word, typed), otherwise);
  const std::string renamed =
      host::help_for_renamed(fmt::format("options of {}", reached.get_name()), word);
  return message(
      fmt::format("`{}` has no option `{}`", typed, word),
      renamed.empty() ? did_you_mean(word, names_of_options(reached), otherwise) : Help(renamed));
}

}  // namespace

std::string usage_message(const CLI::App& app, const CLI::Error& problem) {
  std::string typed;
  const CLI::App* reached = command_reached(app, typed);
  const std::string otherwise = fmt::format("`{} --help` lists the options", typed);
  const std::vector<std::string> commands = names_of_commands(*reached);
  const auto is = [&](CLI::ExitCodes code) {
    return problem.get_exit_code() == static_cast<int>(code);
  };
  if (is(CLI::ExitCodes::ExtrasError)) return too_much(*reached, typed, otherwise);
  if (is(CLI::ExitCodes::RequiredError) && !commands.empty()) {
    const std::vector<std::string> rest = reached->remaining();
    const std::string list = fmt::format("{}", join(commands, ", "));
    if (!rest.empty() && rest.front().starts_with('-')) return too_much(*reached, typed, otherwise);
    if (!rest.empty())
      return message(fmt::format("`{}` has no `{}`", typed, rest.front()),
                     did_you_mean(rest.front(), commands, "available: " + list));
    return message(fmt::format("`{}` alone is not enough", typed),
                   reached == &app ? "give a graph, or one of " + list : "available: " + list);
  }
  const std::string said = problem.what();
  const std::size_t end = said.find('\n');  // of not_a_choice()
  return message(said.substr(0, end), end == std::string::npos ? otherwise : said.substr(end + 1));
}

std::string not_a_choice(const std::string& word, const std::vector<std::string>& choices) {
  const std::string list = fmt::format("available: {}", join(choices, ", "));
  return fmt::format("`{}` is not possible\n{}", word, did_you_mean(word, choices, list).text);
}

std::string not_a_command(const CLI::App& app, const std::string& word) {
  const bool like_one = !word.empty() && ranges::all_of(word, [](unsigned char c) {
    return std::isalpha(c) != 0 || c == '-';
  });
  std::error_code ignored;
  if (!like_one || std::filesystem::exists(word, ignored)) return {};
  const std::vector<std::string> commands = names_of_commands(app);
  return message(fmt::format("`{}` is neither a command nor a file", word),
                 did_you_mean(word, commands, fmt::format("available: {}", join(commands, ", "))));
}

std::string no_help(const CLI::App& app, const std::vector<Topic>& topics,
                    const std::string& word) {
  std::vector<std::string> known = names_of_commands(app);
  for (const Topic& topic : topics) known.push_back(topic.name);
  return message(fmt::format("there is no help for `{}`", word),
                 did_you_mean(word, known, fmt::format("available: {}", join(known, ", "))));
}

}  // namespace eagerx::gen
