// EAGERx's `process:` of nodes, as the graph's placement.
#include <fmt/format.h>

#include <algorithm>

#include "generator/frontend/import/translate.hpp"
#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

/// `process` as EAGERx writes it (eagerx.core.constants.process).
enum class Process : std::uint8_t { new_process, environment, engine, external };

/// Nothing of an entity that does not say it. Reported (E0802) if it is none of the four.
std::optional<Process> process_of(const SavedEntity& entity, Diagnostics& diagnostics) {
  const YamlValue* saved = entity.parameter("process");
  if (saved == nullptr) return std::nullopt;
  constexpr std::string_view kNumbers = "0123";
  const std::size_t number = saved->is_scalar() && saved->text.size() == 1
                                 ? kNumbers.find(saved->text)
                                 : std::string_view::npos;
  if (number != std::string_view::npos) return static_cast<Process>(number);
  diagnostics
      .error("E0802", saved->span,
             fmt::format("`process` of `{}` is none of EAGERx's", entity.name.value))
      .help = "it is 0 (NEW_PROCESS), 1 (ENVIRONMENT), 2 (ENGINE) or 3 (EXTERNAL)";
  return std::nullopt;
}

/// A part that no other node has, under a name that a part may have.
PlacementSpec placed_alone(const std::string& node, Process process, Span span) {
  PlacementSpec item;
  item.name = {node, span};
  item.target = {"linux-sim", span};
  item.part = {node == "host" ? node + "_part" : node, span};
  if (process == Process::external) item.host = {node + "_host", span};
  return item;
}

std::string joined(const std::vector<std::string>& names) {
  return fmt::format("{}", join(names, ", "));
}

}  // namespace

Processes find_processes(const SavedGraph& saved, Diagnostics& diagnostics) {
  Processes result;
  for (const SavedEntity& entity : saved.entities) {
    const auto process = process_of(entity, diagnostics);
    if (!process || *process == Process::environment || *process == Process::engine) continue;
    if (result.place.line == 0) result.place = entity.parameter("process")->span;
    const bool is_node =
        entity.kind == SavedEntity::Kind::node && saved.owner_of(entity.name.value) == nullptr;
    auto& list = !is_node                        ? result.kept
                 : *process == Process::external ? result.elsewhere
                                                 : result.alone;
    list.push_back(entity.name.value);
  }
  return result;
}

namespace {

/// EAGERx's users give nodes a process for speed; one program is faster, with the same messages.
void join_processes(Translation& t, const Processes& processes) {
  std::vector<std::string> names;
  for (const std::string& saved : processes.alone)
    if (t.entity(saved) != nullptr) names.push_back("`" + t.names.at(saved) + "`");
  if (names.empty()) return;
  t.diagnostics
      .note(processes.place,
            fmt::format("one program runs {}, which EAGERx runs in {}", joined(names),
                        names.size() == 1 ? "its own process" : "their own processes"))
      .help =
      "the messages are the same: `eagerx-gen import --keep-processes` makes parts (`placement:`)";
}

}  // namespace

void translate_processes(Translation& t, const Processes& found) {
  if (found.place.line == 0) return;
  Processes processes = found;
  if (!t.options.keep_processes) {
    join_processes(t, found);
    processes.alone.clear();
  }
  std::vector<std::string> alone, elsewhere, kept;
  const auto place = [&](const std::vector<std::string>& nodes, Process process, const char* remark,
                         std::vector<std::string>& said) {
    for (const std::string& saved : nodes) {
      if (t.entity(saved) == nullptr) continue;
      const std::string& name = t.names.at(saved);
      t.result.spec.placement.push_back(
          placed_alone(name, process, t.saved.find(saved)->parameter("process")->span));
      t.result.remarks["placement." + name] = remark;
      said.push_back("`" + name + "`");
    }
  };
  place(processes.alone, Process::new_process, "NEW_PROCESS in EAGERx", alone);
  place(processes.elsewhere, Process::external, "EXTERNAL in EAGERx: name its machine", elsewhere);
  for (const std::string& name : processes.kept)
    kept.push_back(name == "engine" ? "the engine" : "`" + name + "`");
  if (alone.empty() && elsewhere.empty()) {
    if (kept.empty()) return;
    t.diagnostics.note(processes.place,
                       fmt::format("in the main program here, but in EAGERx in its "
                                   "own process: {}",
                                   joined(kept)));
    return;
  }
  std::vector<std::string> texts;
  if (!alone.empty()) texts.push_back(joined(alone) + " on this machine");
  if (!elsewhere.empty()) texts.push_back(joined(elsewhere) + " on a machine for you to name");
  if (!kept.empty()) texts.push_back(joined(kept) + " in the main program, with all of the engine");
  t.diagnostics
      .note(processes.place, fmt::format("what had its own process in EAGERx is a separate "
                                         "program (`placement:`): {}",
                                         join(texts, "; ")))
      .help =
      "one program has the same messages and is faster: leave out of `placement:` what need not "
      "run elsewhere";
}

}  // namespace eagerx::gen
