#include "generator/driver/build/targets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <runtime/host/base/hash.hpp>

#include "generator/backend/languages/layout.hpp"
#include "generator/driver/build/build_tree.hpp"
#include "generator/driver/build/packages.hpp"
#include "generator/frontend/read/text.hpp"
#include "generator/graph/resolve/needs.hpp"
#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {

std::uint64_t warnings_in(const Diagnostics& diagnostics) {
  return static_cast<std::uint64_t>(
      std::ranges::count(diagnostics.all(), Severity::warning, &Diagnostic::severity));
}

namespace {

/// A part of a file's name for what a user has written: itself, or what is left of it and a hash.
std::string name_for(const std::string& written) {
  constexpr std::size_t kMostBytes = 60;
  std::string name = written.substr(0, kMostBytes);
  std::ranges::replace_if(
      name,
      [](char c) {
        const bool is_plain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') ||
                              (c >= 'a' && c <= 'z') || c == '.' || c == '_' || c == '-';
        return !is_plain;
      },
      '_');
  return name == written ? name : fmt::format("{}-{:016x}", name, host::fnv1a(written));
}

}  // namespace

std::string folder_for_options(std::string folder, const GraphOptions& options) {
  for (const std::string& target : options.targets) {
    if (target != "linux-sim") folder += "-" + name_for(target);
  }
  for (const std::string* chosen : {&options.variant, &options.engine, &options.agent_policy}) {
    if (!chosen->empty()) folder += "-" + name_for(*chosen);
  }
  return folder;
}

namespace {

namespace fs = std::filesystem;

/// Whether a board's serial port is the one that the telemetry is planned for.
void check_serial_port(Run& run, const Target& target) {
  const auto& telemetry = run.graph->telemetry;
  if (!telemetry || !target.is_board() || target.baud == telemetry->baud) return;
  auto& problem = run.diagnostics.error(
      "E0341", telemetry->baud_span,
      target.baud ? fmt::format("telemetry over {} baud, but the serial port of `{}` has {}",
                                telemetry->baud, target.id.value, *target.baud)
                  : fmt::format("the serial port of `{}` takes no telemetry", target.id.value));
  if (target.baud) {
    problem.help = fmt::format("write `telemetry: {{baud: {}, …}}`", *target.baud);
  } else {
    problem.notes.push_back({"its manifest has no `baud`", target.id.span, ""});
    problem.help =
        "write `baud:` into the manifest and uart_offer() next to uart_write(), as "
        "targets/README.md says under \"Add a board\"";
  }
}

/// Whether the graph, or the part of it that stays on Linux, can run there.
void check_target(Run& run, const Target& target) {
  if (!target.language.empty()) {
    run.diagnostics
        .error("E0334", {},
               fmt::format("target `{}` runs a part of a graph, not all of it", target.id.value))
        .help = fmt::format("place nodes there: `--split NODE=PART:{}`", target.id.value);
    return;
  }
  check_serial_port(run, target);
  const bool split = run.graph->placement.has_value();
  check_system(*run.graph, split ? Part::hub : Part::whole, target, run.library, run.diagnostics);
  if (target.system.empty() && run.spec->agent.kind == AgentSpec::Kind::csv) {
    run.diagnostics
        .error("E0337", run.spec->agent.file.span,
               fmt::format("the agent reads a file, but target `{}` has no operating system",
                           target.id.value))
        .help = "for boards an agent is `zero`, `random` or `{policy: FILE}`";
  }
  if (!split) return;
  // A target that can run a part on Linux can also run the hub.
  if (target.system == "linux" && !target.partner.empty()) return;
  const Placement& placement = *run.graph->placement;
  const bool is_linux = target.system == "linux";
  run.diagnostics
      .error("E0335", placement.span(),
             is_linux ? fmt::format("target `{}` runs whole graphs only", target.id.value)
                      : fmt::format(
                            "target `{1}` cannot run the part next to `{0}`: that part needs Linux",
                            placement.parts.front().target->id.value, target.id.value))
      .help = is_linux ? fmt::format(
                             "make it by itself and without `--split`, `--target {}` alone: "
                             "then `placement:` does not count",
                             target.id.value)
                       : "leave out `--target`, or name a target of Linux";
}

/// Refuses a target that `eagerx-gen new` has made and whose blanks are not filled in yet.
void check_filled(Run& run, const Target& target) {
  std::vector<std::string> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder_of(run, target), error)) {
    const std::string ending = entry.path().extension().string();
    const bool is_source =
        ending == ".yaml" || ending == ".cpp" || ending == ".hpp" || ending == ".cmake";
    if (is_source && entry.is_regular_file(error)) files.push_back(entry.path().string());
  }
  std::ranges::sort(files);
  std::vector<Diagnostic::Note> blanks;
  for (const std::string& file : files) {
    const std::string text = load_file(file, ReadLimits().max_bytes).bytes;
    if (text.find("FILL_IN") == std::string::npos && text.find("#error") == std::string::npos)
      continue;
    const FileId id = run.sources.add(file, text);
    const auto lines = std::ranges::count(text, '\n');
    for (std::uint32_t line = 1; line <= lines; ++line) {
      const std::string_view words = run.sources.line(id, line);
      for (const std::string_view mark : {"FILL_IN", "#error \"fill in"}) {
        const std::size_t at = words.find(mark);
        if (at == std::string_view::npos) continue;
        const Span place{id, line, static_cast<std::uint32_t>(at + 1),
                         static_cast<std::uint32_t>(mark.size())};
        blanks.push_back({mark == "FILL_IN" ? fmt::format("line {} is a blank", line)
                                            : "a function has to be written",
                          place, "here"});
      }
    }
  }
  if (blanks.empty()) return;
  auto& problem =
      run.diagnostics.error("E0340", target.id.span,
                            fmt::format("the target `{}` is not filled in: {} left",
                                        target.id.value, counted(blanks.size(), "blank")));
  problem.notes = std::move(blanks);
  problem.help = "targets/README.md of eagerx-gen explains them under \"Add a board\"";
}

/// Boards by their family (`stm32`), and other build systems, which are packages (`arduino`).
Help help_with_target(const Run& run, const std::string& wanted,
                      const std::vector<std::string>& known) {
  const auto names = [&](const std::string& word) {
    return wanted.size() >= 3 && (word.starts_with(wanted) || wanted.starts_with(word));
  };
  const std::string system = wanted.starts_with("esp32") ? "esp-idf"
                             : wanted == "teensy" || wanted == "pico" || wanted == "rp2040"
                                 ? "arduino"
                             : wanted.starts_with("nucleo") || wanted == "discovery" ? "platformio"
                                                                                     : wanted;
  for (const std::string& package : names_of_packages(run)) {
    if (system == package || names(package))
      return fmt::format("it is a package: `eagerx-gen generate GRAPH.yaml --package {}`", package);
  }
  const bool is_raspberry =
      wanted.starts_with("raspberry") || wanted == "rpi" || wanted == "jetson";
  const std::string prefix = is_raspberry ? "linux-a" : wanted;
  std::vector<std::string> family;
  for (const std::string& id : known)
    if (names(id) || id.starts_with(prefix)) family.push_back(fmt::format("`{}`", id));
  if (family.empty()) return suggestion(wanted, known);
  return fmt::format("did you mean {}? A board of your own: `eagerx-gen new board NAME`",
                     join(family, " or "));
}

}  // namespace

std::vector<const Target*> find_targets(Run& run, const GraphOptions& options) {
  std::vector<const Target*> result;
  for (const auto& wanted : wanted_targets(options)) {
    if (const Target* found = run.library.find_target(wanted)) {
      result.push_back(found);
      check_target(run, *found);
      check_filled(run, *found);
      continue;
    }
    std::vector<std::string> known;
    for (const auto& [id, target] : run.library.all_targets())
      if (target.language.empty()) known.push_back(id);
    run.diagnostics.error("E0316", {}, fmt::format("unknown target `{}`", wanted)).help =
        help_with_target(run, wanted, known);
  }
  for (std::size_t part = 0; run.graph->placement && part < run.graph->placement->parts.size();
       ++part) {
    const Target& target = *run.graph->placement->parts[part].target;
    check_filled(run, target);
    if (!target.language.empty()) check_languages(*run.plan, part, run.diagnostics);
    check_system(*run.graph, Part::placed(part), target, run.library, run.diagnostics);
  }
  return result;
}

}  // namespace eagerx::gen
