#include "generator/support/command_line/completions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

/// The kind of word that may follow, by the form of the value that the table shows.
bool is_folder(const Argument& argument) {
  return argument.type == "DIR";
}
bool is_file(const Argument& argument) {
  const bool has_ending = argument.type.find('.') != std::string::npos &&
                          argument.type.find("...") == std::string::npos;
  return has_ending || argument.type == "FILE" || argument.type == "LOG" ||
         argument.type == "PROGRAM" || argument.type == "LOG LOG";
}

std::string words_of(const std::vector<Command>& commands) {
  std::vector<std::string> names;
  names.reserve(commands.size());
  for (const Command& command : commands) names.push_back(command.name);
  return fmt::format("{}", join(names, " "));
}

std::string options_of(const Command& command) {
  std::string words = "--help";
  for (const Argument& argument : command.arguments) {
    if (argument.is_option())
      words += " " + fmt::format("{}", join(comma_separated(argument.names), " "));
  }
  return words;
}

/// Every command with the words that lead to it: "policy", "policy info".
std::vector<std::pair<std::string, Command>> all_of(const std::vector<Command>& commands,
                                                    const std::string& before = "") {
  std::vector<std::pair<std::string, Command>> all;
  for (const Command& command : commands) {
    all.emplace_back(before + command.name, command);
    for (auto& inner : all_of(command.commands, before + command.name + " "))
      all.push_back(std::move(inner));
  }
  return all;
}

/// The branches of `case "$path $before"` for the values of options.
std::string bash_values(const std::string& path, const Command& command) {
  std::string text;
  for (const Argument& argument : command.arguments) {
    if (!argument.is_option() || argument.type.empty()) continue;
    const std::string reply = !argument.choices.empty()
                                  ? fmt::format("-W '{}'", join(argument.choices, " "))
                              : is_folder(argument) ? "-d"
                              : is_file(argument)   ? "-f"
                                                    : "";
    std::string patterns;
    for (const std::string& name : comma_separated(argument.names))
      patterns += fmt::format("{}'{}:{}'", patterns.empty() ? "" : "|", path, name);
    text += fmt::format("    {})\n      {}\n      return ;;\n", patterns,
                        reply.empty() ? "COMPREPLY=()" : "reply " + reply);
  }
  return text;
}

}  // namespace

std::string bash_completion(const CommandLine& line, const std::vector<Command>& commands) {
  std::string function = "_" + line.top.name;
  std::ranges::replace(function, '-', '_');
  std::vector<std::pair<std::string, Command>> all = all_of(commands);
  all.emplace_back("", line.top);
  std::string values, words, paths;
  for (const auto& [path, command] : all) {
    values += bash_values(path, command);
    const std::vector<Command>& inner = path.empty() ? commands : command.commands;
    std::string more = words_of(inner);
    if (path == "help") {
      more = words_of(commands);
      for (const Topic& topic : line.topics) more += " " + topic.name;
    }
    const bool files = path != "help" && (inner.empty() || path.empty());
    words += fmt::format("    '{}')\n      reply -W '{}{}{}'{} ;;\n", path, more,
                         more.empty() ? "" : " ", options_of(command), files ? " -f" : "");
    if (!path.empty()) paths += fmt::format("{}'{}'", paths.empty() ? "" : "|", path);
  }
  return fmt::format(R"(# bash completion of {0}, made from its table of commands
{1}() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}} path='' word
  reply() {{ mapfile -t COMPREPLY < <(compgen "$@" -- "$current"); }}
  for word in "${{COMP_WORDS[@]:1:COMP_CWORD-1}}"; do
    case "${{path:+$path }}$word" in
    {2}) path=${{path:+$path }}$word ;;
    esac
  done
  compopt -o filenames 2>/dev/null
  case "$path:$before" in
{3}  esac
  case $path in
{4}  esac
}}
complete -F {1} {0}
)",
                     line.top.name, function, paths.empty() ? "''" : paths, values, words);
}

namespace {

/// A text within single quotes, as zsh takes it.
std::string zsh_text(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

/// The branches of `case "$place:$before"` for the values of options.
std::string zsh_values(const std::string& place, const Command& command) {
  std::string text;
  for (const Argument& argument : command.arguments) {
    if (!argument.is_option() || argument.type.empty()) continue;
    const std::string offer = !argument.choices.empty()
                                  ? fmt::format("compadd -- {}", join(argument.choices, " "))
                              : is_folder(argument) ? "_files -/"
                              : is_file(argument)   ? "_files"
                                                    : "_message " + zsh_text(argument.type);
    std::string patterns;
    for (const std::string& name : comma_separated(argument.names))
      patterns += fmt::format("{}'{}:{}'", patterns.empty() ? "" : "|", place, name);
    text += fmt::format("  {})\n    {}\n    return ;;\n", patterns, offer);
  }
  return text;
}

/// The branch of `case $place`: what may follow there besides values of options.
std::string zsh_words(const std::string& place, const Command& command,
                      const std::vector<Command>& inner, const std::vector<Topic>& topics) {
  std::string text = fmt::format("  '{}')\n    offered=(", place);
  for (const Command& each : inner) text += "\n      " + zsh_text(each.name + ":" + each.about);
  for (const Topic& topic : topics) text += "\n      " + zsh_text(topic.name + ":" + topic.about);
  for (const Argument& argument : command.arguments) {
    if (argument.is_option()) continue;
    for (const std::string& word : argument.choices) text += "\n      " + zsh_text(word);
  }
  text += ")\n    options=('--help:print the help and exit'";
  for (const Argument& argument : command.arguments) {
    if (!argument.is_option()) continue;
    for (const std::string& name : comma_separated(argument.names))
      text += "\n      " + zsh_text(name + ":" + argument.about);
  }
  const bool files = place != "help" && (inner.empty() || place.empty());
  return text + ")" + (files ? "\n    _files" : "") + " ;;\n";
}

}  // namespace

std::string zsh_completion(const CommandLine& line, const std::vector<Command>& commands) {
  std::vector<std::pair<std::string, Command>> all = all_of(commands);
  all.emplace_back("", line.top);
  std::string values, words, places;
  for (const auto& [place, command] : all) {
    values += zsh_values(place, command);
    const bool help = place == "help";
    const std::vector<Command>& inner = place.empty() || help ? commands : command.commands;
    words += zsh_words(place, command, inner, help ? line.topics : std::vector<Topic>());
    if (!place.empty()) places += fmt::format("{}'{}'", places.empty() ? "" : "|", place);
  }
  return fmt::format(R"(#compdef {0}
# zsh completion of {0}, made from its table of commands
local place='' word before=${{words[CURRENT-1]}}
local -a offered options
for word in "${{(@)words[2,CURRENT-1]}}"; do
  case "${{place:+$place }}$word" in
  {1}) place="${{place:+$place }}$word" ;;
  esac
done
case "$place:$before" in
{2}esac
case $place in
{3}esac
(( $#offered )) && _describe word offered
_describe -o option options
)",
                     line.top.name, places.empty() ? "''" : places, values, words);
}

namespace {

std::string fish_text(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\'' || c == '\\') result += '\\';
    result += c;
  }
  return result;
}

std::string fish_option(const std::string& before, const Argument& argument) {
  std::string text = before;
  for (const std::string& name : comma_separated(argument.names))
    text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (!argument.choices.empty()) {
    text += fmt::format(" -x -a '{}'", join(argument.choices, " "));
  } else if (!argument.type.empty()) {
    text += is_folder(argument) || is_file(argument) ? " -r" : " -x";
  }
  return text + fmt::format(" -d '{}'\n", fish_text(argument.about));
}

}  // namespace

std::string fish_completion(const CommandLine& line, const std::vector<Command>& commands) {
  const std::string& name = line.top.name;
  std::string text =
      fmt::format("# fish completion of {}, made from its table of commands\n", name);
  for (const Command& command : commands)
    text += fmt::format("complete -c {} -n __fish_use_subcommand -a {} -d '{}'\n", name,
                        command.name, fish_text(command.about));
  for (const Argument& argument : line.top.arguments) {
    if (argument.is_option()) text += fish_option("complete -c " + name, argument);
  }
  for (const Command& command : commands) {
    const std::string seen =
        fmt::format("complete -c {} -n '__fish_seen_subcommand_from {}'", name, command.name);
    for (const Command& inner : command.commands)
      text += fmt::format("{} -f -a {} -d '{}'\n", seen, inner.name, fish_text(inner.about));
    std::vector<const Command*> with_options = {&command};
    for (const Command& inner : command.commands) with_options.push_back(&inner);
    std::vector<std::string> done;
    for (const Command* each : with_options) {
      for (const Argument& argument : each->arguments) {
        if (!argument.is_option() || ranges::contains(done, argument.names)) continue;
        done.push_back(argument.names);
        text += fish_option(seen, argument);
      }
    }
  }
  for (const Topic& topic : line.topics)
    text += fmt::format("complete -c {} -n '__fish_seen_subcommand_from help' -f -a {} -d '{}'\n",
                        name, topic.name, fish_text(topic.about));
  return text;
}

}  // namespace eagerx::gen
