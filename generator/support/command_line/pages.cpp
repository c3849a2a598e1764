// Files from the table of the command line: manual pages (man 7 man), completions, the table.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "generator/support/command_line/command_line.hpp"
#include "generator/support/command_line/completions.hpp"
#include "generator/support/diagnostics/utf8.hpp"

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
      if (argument.is_option()) continue;
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
    if (argument.is_option()) {
      for (const std::string& name : comma_separated(argument.names))
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

/// A line for each argument of a command and of those inside it.
void add_rows(const std::string& name, const Command& command, std::string& rows) {
  constexpr const char* kUses[] = {"none", "reads", "writes", "folder"};
  for (const Argument& each : command.arguments) {
    const std::string choice = each.choices.empty() ? "" : each.choices.front();
    rows += fmt::format("{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\n", name, each.names, each.type,
                        kUses[static_cast<std::size_t>(each.use)], each.required, each.values,
                        each.continues, choice, each.about);
  }
  for (const Command& inner : command.commands) add_rows(name + " " + inner.name, inner, rows);
}

/// The table of arguments, for tests that try all of them.
std::string arguments_page(const std::vector<Command>& commands) {
  std::string rows = "command\tnames\ttype\tuse\trequired\tvalues\tcontinues\tchoice\tabout\n";
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
