#include "generator/command_line/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <sstream>
#include <utility>

#include "generator/command_line/output.hpp"
#include "generator/command_line/usage.hpp"

namespace eagerx::gen {
namespace {

/// Without a description: the help shows the choices as the type already.
CLI::Validator validator_of(const Argument& argument) {
  if (!argument.choices.empty()) return CLI::IsMember(argument.choices).description("");
  return {argument.check, ""};
}

void add(CLI::App& app, const Argument& argument) {
  if (argument.type.empty()) {
    app.add_flag_callback(
        argument.names, [&argument] { argument.take({}); }, argument.about);
    return;
  }
  CLI::Option& option = *app.add_option(
      argument.names,
      [&argument](const CLI::results_t& values) {
        argument.take(values);
        return true;
      },
      argument.about);
  option.type_name(argument.type)->required(argument.required);
  if (argument.check || !argument.choices.empty()) option.check(validator_of(argument));
  option.expected(static_cast<int>(argument.values));
  if (argument.repeated) {
    // What follows the value is the next argument, not another value.
    option.expected(1, CLI::detail::expected_max_vector_size)->allow_extra_args(false);
  }
}

void add(CLI::App& app, const Command& command) {
  for (const Argument& argument : command.arguments) add(app, argument);
  for (const Command& inner : command.commands)
    add(*app.add_subcommand(inner.name, inner.about), inner);
  if (!command.commands.empty()) app.require_subcommand(1);
  if (command.check) {
    app.callback([&command] {
      if (const std::string problem = command.check(); !problem.empty())
        throw CLI::RequiredError(problem, CLI::ExitCodes::RequiredError);
    });
  }
}

/// The innermost command that was given.
const Command& given(const CLI::App& app, const Command& command) {
  for (const Command& inner : command.commands) {
    if (app.got_subcommand(inner.name)) return given(*app.get_subcommand(inner.name), inner);
  }
  return command;
}

/// The exit code of a command, once all that it printed has been taken.
int told(int code) {
  const auto why = flush_output();
  if (!why) return code;
  Diagnostics diagnostics;
  report_output(*why, diagnostics);
  std::fputs(render_text(diagnostics, {}, false).c_str(), stderr);
  return kInputOutput;
}

}  // namespace

Argument flag(std::string names, bool& value, std::string about) {
  return {std::move(names), std::move(about), "", [&value](const auto&) { value = true; }};
}

Argument text(std::string names, std::string& value, std::string about, std::string type) {
  return {std::move(names), std::move(about), std::move(type),
          [&value](const auto& values) { value = values.front(); }};
}

Argument texts(std::string names, std::vector<std::string>& values, std::string about,
               std::string type) {
  Argument argument{std::move(names), std::move(about), std::move(type),
                    [&values](const auto& all) {
                      values.clear();
                      for (const std::string& each : all) {
                        if (std::ranges::find(values, each) == values.end()) values.push_back(each);
                      }
                    }};
  argument.repeated = true;
  return argument;
}

Argument choice(std::string names, std::vector<std::string> choices, std::string about,
                std::function<void(const std::string&)> take) {
  std::string type;
  for (const std::string& each : choices) type += (type.empty() ? "" : "|") + each;
  Argument argument{std::move(names), std::move(about), std::move(type),
                    [take = std::move(take)](const auto& values) { take(values.front()); }};
  argument.choices = std::move(choices);
  return argument;
}

Argument required(Argument argument) {
  argument.required = true;
  return argument;
}

int run_command_line(const CommandLine& line, std::vector<std::string> arguments) {
  open_standard_descriptors();
  CLI::App app(line.top.about, line.top.name);
  app.footer(line.footer);
  if (!line.version.empty()) app.set_version_flag("--version", line.version);
  app.failure_message([](const CLI::App* failed, const CLI::Error& problem) {
    return usage_message(*failed, problem);
  });
  add(app, line.top);
  const std::string first = arguments.empty() ? std::string("-") : arguments.front();
  if (!line.default_command.empty() && !first.starts_with('-') &&
      std::ranges::find(line.top.commands, first, &Command::name) == line.top.commands.end()) {
    if (const std::string problem = not_a_command(app, first); !problem.empty()) {
      complain_text(problem);
      return kWrongUsage;
    }
    arguments.insert(arguments.begin(), line.default_command);
  }
  std::ranges::reverse(arguments);  // as CLI11 takes them
  try {
    app.parse(std::move(arguments));
  } catch (const CLI::ParseError& error) {
    std::ostringstream help, problem;
    const int code = app.exit(error, help, problem);
    say_text(help.str());
    complain_text(problem.str());
    return told(code == 0 ? kDone : kWrongUsage);
  }
  return told(given(app, line.top).run());
}

}  // namespace eagerx::gen
