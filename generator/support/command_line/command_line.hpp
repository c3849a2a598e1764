// The command line of a program as data, and its parser. CLI11 stays inside this
// folder: its headers take longer to compile than a whole stage.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace eagerx::gen {

/// Exit codes, the same for all commands of all programs.
enum ExitCode : int { kDone = 0, kProblems = 1, kWrongUsage = 2, kInputOutput = 3, kInternal = 4 };

/// A command's use of the files that an argument names. It decides which files may be one:
/// an output is no input and no other output, by any name or link.
enum class FileUse : std::uint8_t {
  none,
  reads,
  writes,
  folder,  // the code that reads or writes there reports the files
};

/// An option or a positional argument.
struct Argument {
  std::string names;  // "graph", "--engine", "-o,--output"
  std::string about;
  std::string type;  // of its value in the help: "NAME"; a flag has none
  /// Stores the values: one, `values` of them, or all values of a repeated argument.
  std::function<void(const std::vector<std::string>&)> take;
  /// The problem of a value, or "".
  std::function<std::string(const std::string&)> check = {};
  std::vector<std::string> choices = {};  // the only values; empty: any
  std::size_t values = 1;                 // that follow the option
  bool repeated = false;
  bool required = false;
  FileUse use = FileUse::none;
  std::string otherwise = {};  // of an output: the file that is written if none is given
  std::string continues = {};  // of an input: the option whose output may be the same file

  [[nodiscard]] bool is_option() const { return names.starts_with('-'); }
};

/// "-o,--output": "-o", "--output"
std::vector<std::string> comma_separated(std::string_view text);

/// A working command line, and its purpose.
struct Example {
  std::string about;
  std::string command;
};

/// A command, or with `commands` a group of them.
struct Command {
  std::string name;
  std::string about;
  std::vector<Example> examples = {};
  std::vector<Argument> arguments = {};
  /// If set, takes words for another program: after the first positional argument, every option
  /// that is not in `arguments`, the word after it, and everything after `--`. Otherwise such
  /// options are errors.
  std::optional<Argument> rest = {};
  std::vector<Command> commands = {};
  /// A conflict between the arguments, or "". Called after all were read.
  std::function<std::string()> check = {};
  std::function<int()> run = {};
  bool hidden = false;                 // from the help: not for people
  std::shared_ptr<void> options = {};  // what `arguments` store in, kept as long as they
};

/// The topics of `help NAME` other than commands.
struct Topic {
  std::string name;
  std::string about;
  std::string text;
};

/// A program with one command or several.
struct CommandLine {
  Command top;
  std::string footer = {};           // of `--help`
  std::string version = {};          // what `--version` prints; empty: there is no such option
  std::string default_command = {};  // is put before a file name that comes first
  std::vector<Topic> topics = {};    // with commands there is also `help [COMMAND|TOPIC]`
};

/// Arguments of common kinds. `texts` may be repeated; duplicates are dropped.
Argument flag(std::string names, bool& value, std::string about);
Argument text(std::string names, std::string& value, std::string about, std::string type);
Argument texts(std::string names, std::vector<std::string>& values, std::string about,
               std::string type);
Argument choice(std::string names, std::vector<std::string> choices, std::string about,
                std::function<void(const std::string&)> take);
Argument required(Argument argument);
/// A value that is not `good` is refused: "VALUE PROBLEM", such as "x ends in none of .svg, .dot".
Argument checked(Argument argument, std::function<bool(const std::string&)> good,
                 std::string problem);
/// An option with a whole number from `low` to `high`.
Argument whole(std::string names, std::optional<std::uint64_t>& value, std::string about,
               std::uint64_t low, std::uint64_t high);
/// The argument names files that are read, or with `continues` one that this output continues.
Argument reads(Argument argument, std::string continues = {});
/// The argument names the file to write; `otherwise`: its default.
Argument writes(Argument argument, std::string otherwise = {});
Argument folder(Argument argument);
/// An option that runtime/STABILITY.md does not promise yet; its description ends with
/// "(experimental)".
Argument experimental(Argument argument);
Command experimental(Command command);

/// Reads the arguments (without the program's name) and runs the command; returns the exit code. A
/// command line that is wrong gets an `error:` line, where there is one a `help:` line, and
/// kWrongUsage.
int run_command_line(const CommandLine& line, std::vector<std::string> arguments);

/// The commands as people see them: with `help`, without hidden ones.
std::vector<Command> visible_commands(const CommandLine& line);

/// A file made from the table: where it belongs, and its text.
struct CommandLinePage {
  std::string path;
  std::string text;
};
/// `man/…` has a manual page of the program and of each command, `bash/…`, `zsh/…` and
/// `fish/…` what completes its command line there, and `PROGRAM.tsv` the table itself.
std::vector<CommandLinePage> command_line_pages(const CommandLine& line);

}  // namespace eagerx::gen
