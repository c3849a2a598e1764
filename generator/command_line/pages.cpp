// Manual pages (man 7 man) and completions of shells, from the table of the command line.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "generator/command_line/command_line.hpp"
#include "generator/diagnostics/utf8.hpp"

namespace eagerx::gen {
namespace {

/// As roff takes a text: no hyphen becomes a dash, no line is a request, and a character that is
/// not of ASCII is called by its code.
std::string roff(std::string_view text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const CodePoint point = decode_utf8(text, at);
    const char c = text[at];
    at += point.size;
    if (point.size > 1) {
      result += fmt::format("\\[u{:04X}]", static_cast<std::uint32_t>(point.value));
      continue;
    }
    const bool line_begins = result.empty() || result.back() == '\n';
    if (line_begins && (c == '.' || c == '\'')) result += "\\&";
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";
    } else {
      result += c;
    }
  }
  return result;
}

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

bool is_option(const Argument& argument) {
  return argument.names.starts_with('-');
}

/// "-o,--output" → "-o", "--output"
std::vector<std::string> names_of_option(const Argument& argument) {
  std::vector<std::string> names;
  for (std::size_t begin = 0; begin <= argument.names.size();) {
    const std::size_t end = std::min(argument.names.find(',', begin), argument.names.size());
    names.push_back(argument.names.substr(begin, end - begin));
    begin = end + 1;
  }
  return names;
}

class ManualPage {
 public:
  ManualPage(const CommandLine& line, std::string title) : title_(std::move(title)) {
    text_ = fmt::format(".TH {} 1 \"\" \"{}\" \"{}\"\n", upper(roff(title_)), roff(line.version),
                        roff(line.top.name));
  }

  void name(const std::string& about) {
    text_ += fmt::format(".SH NAME\n{} \\- {}\n", roff(title_), roff(about));
  }

  /// `words`: what is typed, "eagerx-gen policy info".
  void command(const std::string& words, const Command& command) {
    text_ += fmt::format(".SH SYNOPSIS\n.B {}\n", roff(words));
    if (!command.commands.empty()) text_ += ".I COMMAND\n";
    text_ += "[\\fIOPTIONS\\fR]\n";
    for (const Argument& argument : command.arguments) {
      if (is_option(argument)) continue;
      const std::string type = fmt::format("\\fI{}\\fR", roff(argument.type));
      text_ += argument.required ? type + "\n" : "[" + type + "]\n";
    }
    if (command.rest) text_ += fmt::format("[\\fI{}\\fR]\n", roff(command.rest->type));
    if (!command.arguments.empty()) text_ += ".SH OPTIONS\n";
    for (const Argument& argument : command.arguments) text_ += option(argument);
    if (command.rest) text_ += option(*command.rest);
    examples(command);
    for (const Command& inner : command.commands) {
      if (!inner.hidden) this->inner(words + " " + inner.name, inner);
    }
  }

  void inner(const std::string& words, const Command& command) {
    text_ += fmt::format(".SH {}\n{}.\n", upper(roff(words)), roff(command.about));
    for (const Argument& argument : command.arguments) text_ += option(argument);
    examples(command);
  }

  void examples(const Command& command) {
    if (command.examples.empty()) return;
    text_ += ".SH EXAMPLES\n";
    for (const Example& example : command.examples)
      text_ += fmt::format(".PP\n{}:\n.PP\n.nf\n.RS\n{}\n.RE\n.fi\n", roff(example.about),
                           roff(example.command));
  }

  void section(const std::string& title, const std::string& text) {
    text_ += fmt::format(".SH {}\n.nf\n{}\n.fi\n", upper(roff(title)), roff(text));
  }

  void raw(const std::string& text) { text_ += text; }
  [[nodiscard]] std::string text() const { return text_; }

 private:
  static std::string option(const Argument& argument) {
    std::string names;
    if (is_option(argument)) {
      for (const std::string& name : names_of_option(argument))
        names += (names.empty() ? "\\fB" : ", \\fB") + roff(name) + "\\fR";
      if (!argument.type.empty()) names += fmt::format(" \\fI{}\\fR", roff(argument.type));
    } else {
      names = fmt::format("\\fI{}\\fR", roff(argument.type));
    }
    return fmt::format(".TP\n{}\n{}\n", names, roff(argument.about));
  }

  std::string title_;
  std::string text_;
};

std::string page_of_program(const CommandLine& line, const std::vector<Command>& commands) {
  ManualPage page(line, line.top.name);
  page.name(line.top.about);
  Command top = line.top;
  top.commands.clear();
  page.command(line.top.name, top);
  if (!commands.empty()) {
    page.raw(".SH COMMANDS\n");
    for (const Command& command : commands)
      page.raw(fmt::format(".TP\n\\fB{0}\\fR\n{1}: {2}\\-{0}(1)\n", roff(command.name),
                           roff(command.about), roff(line.top.name)));
  }
  if (!line.footer.empty()) page.section("notes", line.footer);
  for (const Topic& topic : line.topics) page.section(topic.name, topic.text);
  return page.text();
}

/// What may follow, by the form of the value that the table shows.
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
  return fmt::format("{}", fmt::join(names, " "));
}

std::string options_of(const Command& command) {
  std::string words = "--help";
  for (const Argument& argument : command.arguments) {
    if (is_option(argument))
      words += " " + fmt::format("{}", fmt::join(names_of_option(argument), " "));
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
    if (!is_option(argument) || argument.type.empty()) continue;
    const std::string reply = !argument.choices.empty()
                                  ? fmt::format("-W '{}'", fmt::join(argument.choices, " "))
                              : is_folder(argument) ? "-d"
                              : is_file(argument)   ? "-f"
                                                    : "";
    std::string patterns;
    for (const std::string& name : names_of_option(argument))
      patterns += fmt::format("{}'{}:{}'", patterns.empty() ? "" : "|", path, name);
    text += fmt::format("    {})\n      {}\n      return ;;\n", patterns,
                        reply.empty() ? "COMPREPLY=()" : "reply " + reply);
  }
  return text;
}

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
    if (!is_option(argument) || argument.type.empty()) continue;
    const std::string offer = !argument.choices.empty()
                                  ? fmt::format("compadd -- {}", fmt::join(argument.choices, " "))
                              : is_folder(argument) ? "_files -/"
                              : is_file(argument)   ? "_files"
                                                    : "_message " + zsh_text(argument.type);
    std::string patterns;
    for (const std::string& name : names_of_option(argument))
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
    if (is_option(argument)) continue;
    for (const std::string& word : argument.choices) text += "\n      " + zsh_text(word);
  }
  text += ")\n    options=('--help:print the help and exit'";
  for (const Argument& argument : command.arguments) {
    if (!is_option(argument)) continue;
    for (const std::string& name : names_of_option(argument))
      text += "\n      " + zsh_text(name + ":" + argument.about);
  }
  const bool files = place != "help" && (inner.empty() || place.empty());
  return text + ")" + (files ? "\n    _files" : "") + " ;;\n";
}

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
  for (const std::string& name : names_of_option(argument))
    text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (!argument.choices.empty()) {
    text += fmt::format(" -x -a '{}'", fmt::join(argument.choices, " "));
  } else if (!argument.type.empty()) {
    text += is_folder(argument) || is_file(argument) ? " -r" : " -x";
  }
  return text + fmt::format(" -d '{}'\n", fish_text(argument.about));
}

std::string fish_completion(const CommandLine& line, const std::vector<Command>& commands) {
  const std::string& name = line.top.name;
  std::string text =
      fmt::format("# fish completion of {}, made from its table of commands\n", name);
  for (const Command& command : commands)
    text += fmt::format("complete -c {} -n __fish_use_subcommand -a {} -d '{}'\n", name,
                        command.name, fish_text(command.about));
  for (const Argument& argument : line.top.arguments) {
    if (is_option(argument)) text += fish_option("complete -c " + name, argument);
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
        if (!is_option(argument) || std::ranges::find(done, argument.names) != done.end()) continue;
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

/// A line for each argument of a command and of those inside it.
void add_rows(const std::string& name, const Command& command, std::string& rows) {
  constexpr const char* kUses[] = {"none", "reads", "writes", "folder"};
  for (const Argument& each : command.arguments) {
    const std::string choice = each.choices.empty() ? "" : each.choices.front();
    rows += fmt::format("{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\n", name, each.names, each.type,
                        kUses[static_cast<std::size_t>(each.use)], each.required, each.values,
                        each.goes_on, choice);
  }
  for (const Command& inner : command.commands) add_rows(name + " " + inner.name, inner, rows);
}

/// The table of arguments, for tests that try all of them.
std::string arguments_page(const std::vector<Command>& commands) {
  std::string rows = "command\tnames\ttype\tuse\trequired\tvalues\tgoes_on\tchoice\n";
  for (const Command& command : commands) add_rows(command.name, command, rows);
  return rows;
}

}  // namespace

std::vector<CommandLinePage> command_line_pages(const CommandLine& line) {
  const std::vector<Command> commands = visible_commands(line);
  std::vector<CommandLinePage> pages = {
      {fmt::format("man/{}.1", line.top.name), page_of_program(line, commands)},
      {"bash/" + line.top.name, bash_completion(line, commands)},
      {"zsh/_" + line.top.name, zsh_completion(line, commands)},
      {fmt::format("fish/{}.fish", line.top.name), fish_completion(line, commands)},
      {line.top.name + ".tsv", arguments_page(commands)}};
  for (const Command& command : commands) {
    ManualPage page(line, line.top.name + "-" + command.name);
    page.name(command.about);
    page.command(line.top.name + " " + command.name, command);
    page.raw(fmt::format(".SH SEE ALSO\n{}(1)\n", roff(line.top.name)));
    pages.push_back({fmt::format("man/{}-{}.1", line.top.name, command.name), page.text()});
  }
  return pages;
}

}  // namespace eagerx::gen
