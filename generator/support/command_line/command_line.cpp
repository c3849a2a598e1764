#include "generator/support/command_line/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <sstream>
#include <utility>

#include "generator/support/command_line/output.hpp"
#include "generator/support/command_line/usage.hpp"
#include "generator/support/diagnostics/search.hpp"
#include "generator/support/files/files.hpp"

namespace eagerx::gen {
namespace {

/// Without a description: the help shows the choices as the type already.
CLI::Validator validator_of(const Argument& argument) {
  if (argument.choices.empty()) return {argument.check, ""};
  return {[&argument](const std::string& word) {
            return ranges::contains(argument.choices, word) ? std::string()
                                                            : not_a_choice(word, argument.choices);
          },
          ""};
}

/// The values of the arguments that name files.
using GivenFiles = std::map<const Argument*, std::vector<std::string>>;

void add(CLI::App& app, const Argument& argument, GivenFiles& files) {
  if (argument.type.empty()) {
    app.add_flag_callback(
        argument.names, [&argument] { argument.take({}); }, argument.about);
    return;
  }
  CLI::Option& option = *app.add_option(
      argument.names,
      [&argument, &files](const CLI::results_t& values) {
        if (argument.use != FileUse::none) files[&argument] = values;
        argument.take(values);
        return true;
      },
      argument.about);
  option.type_name(argument.type)->required(argument.required);
  if (argument.check || !argument.choices.empty()) option.check(validator_of(argument));
  option.expected(static_cast<int>(argument.values));
  if (argument.repeated) {
    option.expected(1, CLI::detail::expected_max_vector_size);
    // An option takes one value: the next word is another argument.
    option.allow_extra_args(!argument.names.starts_with('-'));
  }
}

/// Every help ends with examples of its own command.
void add_examples(CLI::App& app, const Command& command) {
  std::string text;
  for (const Example& example : command.examples)
    text +=
        (text.empty() ? "Examples:" : "") + ("\n  # " + example.about + "\n  " + example.command);
  if (!text.empty()) app.footer(text);
}

void add(CLI::App& app, const Command& command, GivenFiles& files) {
  for (const Argument& argument : command.arguments) add(app, argument, files);
  if (command.rest)
    add(app, *command.rest, files);  // for the help: take_rest() has taken all of it
  for (const Command& inner : command.commands) {
    CLI::App& sub = *app.add_subcommand(inner.name, inner.about);
    sub.footer("");
    if (inner.hidden) sub.group("");
    add(sub, inner, files);
  }
  add_examples(app, command);
  if (!command.commands.empty()) app.require_subcommand(1);
  if (command.check) {
    app.callback([&command] {
      if (const std::string problem = command.check(); !problem.empty())
        throw CLI::RequiredError(problem, CLI::ExitCodes::RequiredError);
    });
  }
}

/// The name that messages use: `--output`, `graph`.
std::string long_name(const Argument& argument) {
  return comma_separated(argument.names).back();
}

/// Tells which files are read and written. What is wrong with them, or "".
std::string remember_files(const Command& command, const GivenFiles& given) {
  const auto values_of = [&](const Argument& argument) -> std::vector<std::string> {
    const auto found = given.find(&argument);
    if (found != given.end()) return found->second;
    return argument.otherwise.empty() ? std::vector<std::string>()
                                      : std::vector{argument.otherwise};
  };
  const auto is_gone_on_with = [&](const Argument& input, const std::string& value) {
    return ranges::any_of(command.arguments, [&](const Argument& output) {
      if (long_name(output) != input.continues) return false;
      std::error_code ignored;
      return ranges::any_of(values_of(output), [&](const std::string& path) {
        return path == value || std::filesystem::equivalent(path, value, ignored);
      });
    });
  };
  for (const Argument& argument : command.arguments) {
    for (const std::string& value : values_of(argument)) {
      const std::string name = long_name(argument) + " " + value;
      if (argument.use == FileUse::reads && !is_gone_on_with(argument, value))
        remember_input(value, name);
      if (argument.use == FileUse::writes) remember_output(value, name);
    }
  }
  const auto found = find_one_file();
  return found ? fmt::format("error: `{}` and `{}` are one file\nhelp: give each its own\n",
                             found->output, found->other)
               : "";
}

/// The innermost command that was given.
const Command& given(const CLI::App& app, const Command& command) {
  for (const Command& inner : command.commands) {
    if (app.got_subcommand(inner.name)) return given(*app.get_subcommand(inner.name), inner);
  }
  return command;
}

/// The exit code of a command, once all that it printed has been taken.
int exit_code_of(int code) {
  const auto why = flush_output();
  if (!why) return code;
  Diagnostics diagnostics;
  report_output(*why, diagnostics);
  std::fputs(render_text(diagnostics, {}, false).c_str(), stderr);
  return kInputOutput;
}

const Command* find_command(const Command& top, const std::string& name) {
  const auto found = ranges::find(top.commands, name, &Command::name);
  return found == top.commands.end() ? nullptr : &*found;
}

const Argument* find_option(const Command& command, const std::string& word) {
  const std::string name = word.substr(0, word.find('='));
  const auto found = ranges::find_if(command.arguments, [&](const Argument& argument) {
    const std::vector<std::string> names = comma_separated(argument.names);
    return ranges::contains(names, name);
  });
  return found == command.arguments.end() ? nullptr : &*found;
}

/// Options of the default command may stand before its file, and before another command:
/// `-q graph.yaml`, `-q check graph.yaml`. How many arguments they take; 0 if the first is none.
std::size_t leading_options(const Command& command, const std::vector<std::string>& arguments) {
  std::size_t count = 0;
  while (count < arguments.size() && arguments[count].starts_with('-')) {
    const Argument* option = find_option(command, arguments[count]);
    if (option == nullptr) return 0;
    const bool value_follows =
        !option->type.empty() && arguments[count].find('=') == std::string::npos;
    count += 1 + (value_follows ? option->values : 0);
  }
  return std::min(count, arguments.size());
}

/// Puts the command first. What is wrong with it, or "".
std::string put_command_first(const CLI::App& app, const CommandLine& line,
                              std::vector<std::string>& arguments) {
  const Command* otherwise = find_command(line.top, line.default_command);
  if (otherwise == nullptr || arguments.empty()) return {};
  const std::size_t options = leading_options(*otherwise, arguments);
  if (options == 0 && arguments.front().starts_with('-')) return {};
  if (options < arguments.size()) {
    const auto word = arguments.begin() + static_cast<std::ptrdiff_t>(options);
    if (find_command(line.top, *word) != nullptr) {
      std::rotate(arguments.begin(), word, word + 1);
      return {};
    }
    if (std::string problem = not_a_command(app, *word); !problem.empty()) return problem;
  }
  arguments.insert(arguments.begin(), line.default_command);
  return {};
}

/// Takes the words that are for another program out of the arguments of a command with `rest`.
void take_rest(const Command& command, std::vector<std::string>& arguments) {
  std::vector<std::string> own, rest;
  std::size_t positional = 0;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& word = arguments[i];
    if (word == "--") {
      rest.insert(rest.end(), arguments.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                  arguments.end());
      break;
    }
    const bool is_option = word.size() > 1 && word.front() == '-';
    const Argument* option = is_option ? find_option(command, word) : nullptr;
    const bool is_own = option != nullptr || word == "--help" || positional == 0;
    if (!is_option) ++positional;
    (is_own ? own : rest).push_back(word);
    const bool value_follows =
        option != nullptr && !option->type.empty() && word.find('=') == std::string::npos;
    for (std::size_t n = 0; value_follows && n < option->values && i + 1 < arguments.size(); ++n)
      own.push_back(arguments[++i]);
  }
  arguments = std::move(own);
  if (!rest.empty()) command.rest->take(rest);
}

/// An option whose value was forgotten takes the next option for it. What is wrong, or "".
std::string forgotten_value(const Command& top, const std::vector<std::string>& arguments) {
  const Command* command = &top;
  std::string typed = top.name;
  std::size_t i = 0;
  for (; i < arguments.size(); ++i) {
    const Command* const inner = find_command(*command, arguments[i]);
    if (inner == nullptr) break;
    command = inner;
    typed += " " + inner->name;
  }
  for (; i + 1 < arguments.size() && arguments[i] != "--"; ++i) {
    const std::string& word = arguments[i];
    const Argument* const option = word.starts_with('-') ? find_option(*command, word) : nullptr;
    if (option == nullptr || option->type.empty() || word.find('=') != std::string::npos) continue;
    const std::string& next = arguments[i + 1];
    if (next.starts_with("--") && find_option(*command, next) != nullptr)
      return fmt::format("error: `{}` needs a value\nhelp: `{} --help` lists the options\n", word,
                         typed);
    i += option->values;
  }
  return {};
}

/// The words after `help`: nothing, a command with the one inside it, or a topic.
int print_help(const CommandLine& line, const CLI::App& app,
               const std::vector<std::string>& words) {
  const CLI::App* found = &app;
  for (const std::string& word : words) {
    const auto inner =
        found->get_subcommands([&](const CLI::App* each) { return each->get_name() == word; });
    if (!inner.empty()) {
      found = inner.front();
      continue;
    }
    const auto topic = ranges::find(line.topics, word, &Topic::name);
    if (found == &app && words.size() == 1 && topic != line.topics.end()) {
      say_text(topic->text);
      return kDone;
    }
    complain_text(no_help(*found, line.topics, word));
    return kWrongUsage;
  }
  std::string parents = line.top.name;
  for (std::size_t i = 0; i + 1 < words.size(); ++i) parents += " " + words[i];
  say_text(found->help(words.empty() ? "" : parents));
  if (!words.empty() || line.topics.empty()) return kDone;
  say("\nTopics of `help`:\n");
  for (const Topic& topic : line.topics) say("  {:<27} {}\n", topic.name, topic.about);
  return kDone;
}

Command help_command() {
  return {.name = "help",
          .about = "print the help of a command or a topic",
          .examples = {{"list commands and topics", "eagerx-gen help"},
                       {"help of generate", "eagerx-gen help generate"}},
          .arguments = {{"words", "command or topic (default: list them)", "COMMAND|TOPIC",
                         [](const auto&) {}}},
          .run = [] { return kDone; }};
}

}  // namespace

std::vector<Command> visible_commands(const CommandLine& line) {
  std::vector<Command> commands = line.top.commands;
  std::erase_if(commands, [](const Command& command) { return command.hidden; });
  if (!commands.empty()) commands.push_back(help_command());
  return commands;
}

int run_command_line(const CommandLine& line, std::vector<std::string> arguments) {
  open_standard_descriptors();
  CLI::App app(line.top.about, line.top.name);
  if (!line.version.empty()) app.set_version_flag("--version", line.version);
  app.failure_message([](const CLI::App* failed, const CLI::Error& problem) {
    return usage_message(*failed, problem);
  });
  GivenFiles files;
  add(app, line.top, files);
  app.footer(line.footer);
  const Command help = help_command();
  if (!line.top.commands.empty()) add(*app.add_subcommand(help.name, help.about), help, files);
  if (!line.top.commands.empty() && !arguments.empty() && arguments.front() == help.name &&
      !ranges::contains(arguments, "--help"))
    return exit_code_of(print_help(line, app, {arguments.begin() + 1, arguments.end()}));
  if (const std::string problem = put_command_first(app, line, arguments); !problem.empty()) {
    complain_text(problem);
    return kWrongUsage;
  }
  if (!arguments.empty()) {
    const Command* command = find_command(line.top, arguments.front());
    std::vector<std::string> words(arguments.begin() + 1, arguments.end());
    if (command != nullptr && command->rest) {
      take_rest(*command, words);
      arguments.resize(1);
      arguments.insert(arguments.end(), words.begin(), words.end());
    }
  }
  if (const std::string problem = forgotten_value(line.top, arguments); !problem.empty()) {
    complain_text(problem);
    return kWrongUsage;
  }
  std::ranges::reverse(arguments);  // as CLI11 takes them
  try {
    app.parse(std::move(arguments));
  } catch (const CLI::ParseError& error) {
    std::ostringstream shown, problem;
    const int code = app.exit(error, shown, problem);
    say_text(shown.str());
    complain_text(problem.str());
    return exit_code_of(code == 0 ? kDone : kWrongUsage);
  }
  const Command& command = given(app, line.top);
  if (const std::string problem = remember_files(command, files); !problem.empty()) {
    complain_text(problem);
    return exit_code_of(kWrongUsage);
  }
  return exit_code_of(command.run());
}

}  // namespace eagerx::gen
