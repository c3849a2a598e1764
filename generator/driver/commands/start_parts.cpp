#include "generator/driver/commands/start_parts.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string_view>

#include "generator/support/diagnostics/search.hpp"
#include "generator/support/files/missing_file.hpp"
#include "generator/support/process/companions.hpp"
#include "generator/support/quote/quote.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kLink = "--link";

constexpr std::string_view kKey = "--key";

/// Values of options for links, `PART=LINE` or for one part LINE alone, and for keys.
std::vector<std::string> values_in(const std::vector<std::string>& words, std::string_view option) {
  std::vector<std::string> values;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == option && i + 1 < words.size()) values.push_back(words[++i]);
    if (words[i].starts_with(std::string(option) + "="))
      values.push_back(words[i].substr(option.size() + 1));
  }
  return values;
}

/// The file of the key for the line to `part` that an option names; empty if none does.
std::string key_in(const PlacedPart& part, const std::vector<std::string>& words) {
  std::string found;
  for (const std::string& key : values_in(words, kKey)) {
    const std::size_t equals = key.find('=');
    if (key.substr(0, equals) == part.name && equals != std::string::npos)
      return key.substr(equals + 1);
    if (equals == std::string::npos) found = key;
  }
  return found;
}

/// The parts that no option has a line to.
std::vector<const BuiltProgram*> without_line(const std::vector<BuiltProgram>& programs,
                                              const std::vector<std::string>& words) {
  const std::vector<std::string> lines = values_in(words, kLink);
  std::vector<const BuiltProgram*> result;
  for (const BuiltProgram& program : programs)
    if (program.part != nullptr) result.push_back(&program);
  if (result.size() == 1 && !lines.empty()) return {};
  std::erase_if(result, [&](const BuiltProgram* program) {
    return ranges::any_of(lines, [&](const std::string& line) {
      return line.starts_with(program->part->name + "=");
    });
  });
  return result;
}

/// A port of its own for each part of other machines.
std::uint32_t port_of(const Run& run, const PlacedPart& part) {
  constexpr std::uint32_t kFirst = 7001;
  return kFirst + static_cast<std::uint32_t>(&part - run.graph->placement->parts.data());
}

/// Or else of the graph.
std::string key_of(const PlacedPart& part, const std::vector<std::string>& words) {
  const std::string found = key_in(part, words);
  return found.empty() ? part.key : found;
}

/// The program to copy to another machine, and the command there: a program, or the folder of an
/// interpreted one.
std::pair<std::string, std::string> to_copy(const Run& run, const BuiltProgram& program) {
  const fs::path image = program.image;
  const auto command = command_to_start(run, program);
  if (program.target->language.empty() || command.empty() || command.front() == program.image)
    return {program.image, "./" + shell_word(image.filename().string())};
  const fs::path folder = image.parent_path();
  return {folder.string(), command.front() + " " + shell_word(folder.filename().string())};
}

/// The commands for the other machine and for this one.
std::string how_elsewhere(const Run& run, const BuiltProgram& program, const std::string& key) {
  const PlacedPart& part = *program.part;
  const std::uint32_t port = port_of(run, part);
  const auto [what, there] = to_copy(run, program);
  const std::string host = shell_word(part.host);
  if (!key.empty())
    return fmt::format(
        "copy {} and {} there and type `{} --listen 0.0.0.0:{} --key {}`; then add "
        "`--link {}={}:{}`",
        shell_word(what), shell_word(key), there, port,
        shell_word(fs::path(key).filename().string()), part.name, host, port);
  return fmt::format(
      "copy {} there and type `{} --listen :{}`; here `ssh -N -L {}:localhost:{} {}`; then add "
      "`--link {}=localhost:{}`. Without ssh it takes a key: `eagerx-gen key new {}.key`, then "
      "this "
      "command with `--key {}.key`",
      shell_word(what), there, port, port, port, host, part.name, port, part.name, part.name);
}

void tell_elsewhere(Run& run, const BuiltProgram& program, const std::vector<std::string>& words) {
  const PlacedPart& part = *program.part;
  run.diagnostics
      .error("E0518", part.span,
             fmt::format("part `{}` runs on {}, and this machine cannot start it there", part.name,
                         part.host))
      .help = how_elsewhere(run, program, key_of(part, words));
}

/// Whether one of the options is a TCP line to `part`: others take no key.
bool has_tcp_line(const PlacedPart& part, const std::vector<std::string>& words) {
  return ranges::any_of(values_in(words, kLink), [&](const std::string& line) {
    const std::size_t equals = line.find('=');
    if (equals != std::string::npos && line.substr(0, equals) != part.name) return false;
    const std::string address = line.substr(equals == std::string::npos ? 0 : equals + 1);
    return !address.starts_with("unix:") && address.find('/') == std::string::npos &&
           address.find(':') != std::string::npos;
  });
}

/// The keys of the graph, for lines that no option has a key for.
void add_keys(const std::vector<BuiltProgram>& programs, std::vector<std::string>& words) {
  for (const BuiltProgram& program : programs) {
    const PlacedPart* const part = program.part;
    if (part == nullptr || part->key.empty() || !key_in(*part, words).empty()) continue;
    if (has_tcp_line(*part, words))
      words.insert(words.end(), {std::string(kKey), part->name + "=" + part->key});
  }
}

/// The key of a line that is there, or is going to be, has to be there too.
void check_key(Run& run, const PlacedPart& part, const std::vector<std::string>& words) {
  if (part.host.empty() && !has_tcp_line(part, words)) return;
  const std::string key = key_of(part, words);
  std::error_code error;
  if (key.empty() || fs::exists(key, error)) return;
  const std::string near = help_for_missing(key, key).text;
  run.diagnostics
      .error("E0518", part.span,
             fmt::format("there is no key `{}` for the line to part `{}`", key, part.name))
      .help = near.starts_with("did you mean")
                  ? near
                  : fmt::format("`eagerx-gen key new {}` writes one", shell_word(key));
}

}  // namespace

bool check_parts(Run& run, const std::vector<BuiltProgram>& programs,
                 const std::vector<std::string>& words) {
  const std::size_t before = run.diagnostics.error_count();
  for (const BuiltProgram& program : programs)
    if (program.part != nullptr) check_key(run, *program.part, words);
  if (run.diagnostics.error_count() != before) return false;
  for (const BuiltProgram* program : without_line(programs, words)) {
    if (!program->part->host.empty()) {
      tell_elsewhere(run, *program, words);
    } else if (command_to_start(run, *program).empty()) {
      run.diagnostics
          .error("E0518", program->part->span,
                 fmt::format("part `{}` runs on {}, which nothing here emulates",
                             program->part->name, program->target->id.value))
          .help = fmt::format("load {} onto the board, and name its serial line: `--link {}=LINE`",
                              shell_word(program->image), program->part->name);
    }
  }
  return run.diagnostics.error_count() == before;
}

bool start_parts(Run& run, const std::vector<BuiltProgram>& programs,
                 std::vector<std::string>& words) {
  add_keys(programs, words);
  const auto parts = without_line(programs, words);
  if (parts.empty()) return true;
  // Sockets have short names, and are their owner's alone.
  std::string folder = (fs::temp_directory_path() / "eagerx-gen-XXXXXX").string();
  if (mkdtemp(folder.data()) == nullptr) {
    run.diagnostics.io_error("E0518", {}, fmt::format("cannot make the folder `{}`", folder));
    return false;
  }
  std::vector<Companion> companions;
  for (const BuiltProgram* program : parts) {
    const std::string socket = folder + "/" + program->part->name;
    Companion companion{command_to_start(run, *program), program->build + "/run.log", socket};
    auto& command = companion.command;
    std::vector<std::string> of_board;
    if (program->target->system.empty()) {
      of_board = {"--serial", "unix:" + socket + ",server=on,wait=off"};
    } else {
      command.insert(command.end(), {"--listen", "unix:" + socket});
    }
    if (command.front() != program->image && program->target->language.empty()) {
      of_board.insert(of_board.begin(), {"--time-limit", "0"});  // as long as the hub runs
      command.insert(command.begin() + 2, of_board.begin(), of_board.end());
    }
    companions.push_back(std::move(companion));
    words.insert(words.end(), {std::string(kLink), program->part->name + "=unix:" + socket});
  }
  const auto problem = start_companions(companions, folder);
  if (!problem) return true;
  const PlacedPart& part = *parts[problem->which]->part;
  run.diagnostics
      .error("E0518", part.span,
             fmt::format(
                 "part `{}` {}", part.name,
                 problem->has_ended ? "ended when it was started" : "does not begin to listen"))
      .help = fmt::format("{} has what it said", shell_word(companions[problem->which].log));
  return false;
}

}  // namespace eagerx::gen
