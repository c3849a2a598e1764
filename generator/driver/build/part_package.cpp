#include "generator/driver/build/part_package.hpp"

#include <fmt/format.h>

#include "generator/frontend/read/text.hpp"
#include "generator/support/diagnostics/search.hpp"
#include "generator/support/quote/quote.hpp"

namespace eagerx::gen {
namespace {

std::vector<std::string> languages(const Run& run) {
  std::vector<std::string> ids;
  for (const auto& [id, target] : run.library.all_targets())
    if (!target.language.empty()) ids.push_back(id);
  return ids;
}

PlacedPart* find_part(Run& run, const std::string& name) {
  if (!run.graph->placement) {
    run.diagnostics.error("E0336", run.graph->span, "the graph has no parts").help = fmt::format(
        "say which nodes are one: `placement: {{NODE: {{part: {0}}}}}`, or `--split "
        "NODE={0}:linux-sim`",
        is_plain_word(name) ? name : "PART");
    return nullptr;
  }
  std::vector<std::string> known;
  for (PlacedPart& part : run.graph->placement->parts) {
    if (part.name == name) return &part;
    known.push_back(part.name);
  }
  run.diagnostics
      .error("E0307", run.graph->placement->span(), fmt::format("there is no part `{}`", name))
      .help = suggestion(name, known, "");
  return nullptr;
}

}  // namespace

bool choose_language(Run& run, const GenerateOptions& options) {
  if (options.standalone || options.makes_library()) {
    run.diagnostics.error("E0336", {}, "a part is neither standalone nor a library").help =
        "leave out `--standalone`, `--library` and `--of`";
    return false;
  }
  PlacedPart* const part = find_part(run, options.part);
  if (part == nullptr) return false;
  for (const std::string& name : options.packages) {
    const Target* const target = run.library.find_target(name);
    if (target != nullptr && !target->language.empty()) {
      part->target = target;
      continue;
    }
    run.diagnostics
        .error("E0502", {}, fmt::format("`{}` is not a language that a part can have", name))
        .help = suggestion(name, languages(run));
    return false;
  }
  return true;
}

void keep_part(const std::string& part, std::vector<GeneratedFile>& files) {
  const std::string folder = part + "/";
  std::erase_if(files, [&](const GeneratedFile& file) { return !file.path.starts_with(folder); });
  for (GeneratedFile& file : files) file.path.erase(0, folder.size());
}

std::string next_steps_of_part(const Run& run, const std::string& part, const std::string& folder) {
  const auto& parts = run.graph->placement->parts;
  const Target& target = *ranges::find(parts, part, &PlacedPart::name)->target;
  if (target.language.empty() || target.yours.empty() || target.run.empty()) return "";
  const std::string build = shell_word(folder + "/build");
  std::string compile, start = target.run.front() + " " + shell_word(folder);
  if (target.run.front() == "{image}") {
    compile =
        fmt::format("  cmake -S {} -B {} && cmake --build {}\n", shell_word(folder), build, build);
    start = shell_word(folder + "/build/" + run.graph->name);
  }
  return fmt::format(
      "Fill in {}, then:\n{}  {} --listen unix:/tmp/{}\n  eagerx-gen run {} --link "
      "{}=unix:/tmp/{}\n",
      shell_word(folder + "/" + target.yours.front().second), compile, start, shell_word(part),
      shell_word(run.graph->path), shell_word(part), shell_word(part));
}

}  // namespace eagerx::gen
