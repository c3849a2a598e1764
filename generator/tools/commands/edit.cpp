// eagerx-gen fix and rename: changes of a graph's file that leave the rest as it was written.
#include "generator/tools/edit/edit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <runtime/host/base/nearest.hpp>
#include <set>
#include <utility>
#include <vector>

#include "generator/driver/commands/arguments.hpp"
#include "generator/driver/commands/manifest_check.hpp"
#include "generator/driver/commands/train_file.hpp"
#include "generator/driver/pipeline/pipeline.hpp"
#include "generator/frontend/outline/fixes.hpp"
#include "generator/frontend/outline/lines.hpp"
#include "generator/frontend/read/tree.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"
#include "generator/support/quote/quote.hpp"
#include "generator/tools/commands/tool_commands.hpp"
#include "generator/tools/edit/structure.hpp"
#include "generator/tools/serve/graph_file.hpp"

namespace eagerx::gen {
namespace {

struct EditOptions : LibraryOptions {
  std::string graph;
  std::vector<std::string> files;  // fix
  std::string from, to;            // rename
  bool dry_run = false;
};

/// The file's text as it is, with whatever ends its lines; nothing and an error if it cannot be
/// read.
std::optional<std::string> text_of_file(Run& run, const std::string& path) {
  if (!load_yaml_file(path, run.sources, run.diagnostics)) return std::nullopt;
  std::ifstream file(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), {});
}

/// The problems that `check` finds in this text of the file: a graph, a manifest or settings of a
/// training.
std::unique_ptr<Run> check_of(const EditOptions& options, const std::string& text) {
  auto run = std::make_unique<Run>();
  if (is_manifest(options.graph)) {
    check_manifest(*run, options, options.graph, text);
  } else if (is_train_file(text)) {
    check_train_file(*run, options.graph, text);
  } else {
    GraphOptions graph;
    static_cast<LibraryOptions&>(graph) = options;
    graph.graph = options.graph;
    check_text(*run, graph, text);
  }
  return run;
}

/// The lines that differ, as `diff -U0` shows them. No edit adds or removes a line.
std::string difference(const std::string& name, std::string_view before, std::string_view after) {
  std::string text = fmt::format("--- {}\n+++ {}\n", name, name);
  const auto lines = static_cast<std::uint32_t>(std::ranges::count(before, '\n')) + 1;
  for (std::uint32_t line = 0; line < lines; ++line) {
    const Bytes was = line_of(before, line), is = line_of(after, line);
    const auto old_line = before.substr(was.begin, was.end - was.begin);
    const auto new_line = after.substr(is.begin, is.end - is.begin);
    if (old_line != new_line)
      text += fmt::format("@@ -{0} +{0} @@\n-{1}\n+{2}\n", line + 1, old_line, new_line);
  }
  return text;
}

/// Writes the file, or says what would be another. Never over what somebody else has saved since it
/// was read.
void apply(Run& run, const EditOptions& options, const std::string& before,
           const std::string& after) {
  if (options.dry_run) return say("{}", difference(options.graph, before, after));
  serve::GraphFile file(options.graph);
  const auto written = file.write(before, after);
  if (written == serve::GraphFile::Written::done) return;
  const bool has_changed = written == serve::GraphFile::Written::changed;
  auto& problem = run.diagnostics.io_error(
      "E0901", {},
      fmt::format("cannot write `{}`: {}", options.graph,
                  has_changed ? "another program has changed it meanwhile" : file.problem()));
  if (has_changed) problem.help = "run the command again";
}

bool is_in(const Run& run, const Diagnostic& diagnostic, const std::string& path) {
  return diagnostic.span.file != FileId::none && run.sources.name(diagnostic.span.file) == path;
}

/// Whether there is an error where the other one was.
bool is_wrong_at(const Run& run, const Span& place, const std::string& path) {
  return ranges::any_of(run.diagnostics.all(), [&](const Diagnostic& each) {
    return each.severity == Severity::error && is_in(run, each, path) &&
           each.span.line == place.line && each.span.column == place.column;
  });
}

/// Makes the first change of `text` that the help of an error names and that fixes it: then no
/// error is left at its place. (Elsewhere, errors that it hid may appear.) False: there
/// is none.
bool fix_one(std::unique_ptr<Run>& run, const EditOptions& options, std::string& text) {
  for (const Diagnostic& each : run->diagnostics.all()) {
    const auto fix = is_in(*run, each, options.graph) ? fix_of(each, text) : std::nullopt;
    if (!fix) continue;
    std::string tried = applied(text, fix->splices);
    auto then = check_of(options, tried);
    if (is_wrong_at(*then, each.span, options.graph)) continue;
    if (!options.quiet) say("{}:{}: {}\n", options.graph, each.span.line, fix->reason);
    text = std::move(tried);
    run = std::move(then);
    return true;
  }
  return false;
}

/// Errors in manifests and files that a graph extends are fixed there.
void say_other_files(const Run& run, const EditOptions& options) {
  std::set<std::string> others;
  for (const Diagnostic& each : run.diagnostics.all()) {
    if (each.severity != Severity::error || each.span.file == FileId::none) continue;
    const std::string name = run.sources.name(each.span.file);
    if (name != options.graph && fix_of(each, run.sources.text(each.span.file)))
      others.insert(name);
  }
  if (others.empty()) return;
  std::string words;
  for (const std::string& other : others) words += " " + shell_word(other);
  complain("help: `eagerx-gen fix{}` changes {}\n", words,
           others.size() == 1 ? "that file" : "those files");
}

int fix_file(const EditOptions& options) {
  constexpr int kMost = 1000;  // so that two changes that undo each other come to an end
  Run reading;
  const auto file = text_of_file(reading, options.graph);
  if (!file) return finish(reading, options);
  std::string text = *file;
  auto run = check_of(options, text);
  int made = 0;
  while (made < kMost && fix_one(run, options, text)) ++made;
  if (made > 0) apply(*run, options, *file, text);
  const int code = finish(*run, options);
  if (!options.quiet && made == 0)
    say("{}: there is no error whose help is a change of the text\n", options.graph);
  if (!options.quiet) say_other_files(*run, options);
  return code;
}

/// Fixes each file, also after one that has other problems.
int perform_fix(const EditOptions& options) {
  int worst = kDone;
  for (const std::string& file : options.files) {
    EditOptions of_file = options;
    of_file.graph = file;
    worst = std::max(worst, fix_file(of_file));
  }
  return worst;
}

/// The action or observation that `from` names, alone or as `actions.voltage`.
std::optional<OutlinePath> entry_of(const std::string& text, const std::string& from) {
  const OutlineNode top = outline_of(text);
  std::vector<OutlinePath> found;
  for (const char* const section : {"actions", "observations"}) {
    const OutlineNode* const all = top.find(section);
    if (all == nullptr) continue;
    for (const OutlineEntry& entry : all->entries) {
      const std::string& name = entry.key.empty() ? entry.value.text : entry.key;
      if (from == name || from == fmt::format("{}.{}", section, name) ||
          from == fmt::format("{}/{}", section, name))
        found.push_back({section, name});
    }
  }
  return found.size() == 1 ? std::optional(found.front()) : std::nullopt;
}

/// The section of the graph that has this key, of those whose names `rename` does not change.
std::string section_of(const std::string& text, const std::string& name) {
  const OutlineNode top = outline_of(text);
  for (const OutlineEntry& section : top.entries) {
    if (!section.key.empty() && section.value.find(name) != nullptr) return section.key;
  }
  return {};
}

/// That nothing is called `options.from`, and what was probably meant.
Change no_such_name(const EditOptions& options, const std::string& text) {
  const std::string problem = fmt::format("`{}` has no object, node, action or observation `{}`",
                                          options.graph, options.from);
  const std::string owner = options.from.substr(0, options.from.find_first_of("./["));
  if (owner != options.from && !uses_of(text, owner).empty())
    return {{},
            problem,
            fmt::format("what is inside of `{0}` has its name in the manifest of its type; "
                        "`eagerx-gen rename {1} {0} NEW` renames `{0}`",
                        owner, shell_word(options.graph))};
  if (const std::string section = section_of(text, options.from); !section.empty())
    return {
        {},
        problem,
        fmt::format("it is the name of one of `{}:`: change it where the graph has it", section)};
  return {{}, problem, host::suggestion(options.from, owners_of(text))};
}

/// Why an object or a node cannot be called `options.to`.
Change no_free_name(const EditOptions& options, const std::string& text) {
  if (options.to == options.from) return {{}, fmt::format("`{}` has this name", options.from), {}};
  if (ranges::contains(owners_of(text), options.to))
    return {{}, fmt::format("there is `{}` already", options.to), "choose another name"};
  return {{},
          fmt::format("`{}` cannot be the name of an object or a node", options.to),
          "a name has letters, digits and `_`, begins with a letter, and is not `actions`, "
          "`observations`, `engine` or `environment`"};
}

Change renamed(const EditOptions& options, const std::string& text) {
  if (auto edit = rename(text, options.from, options.to)) return {std::move(edit)};
  if (!uses_of(text, options.from).empty()) return no_free_name(options, text);
  const auto entry = entry_of(text, options.from);
  return entry ? rename_entry(text, *entry, options.to) : no_such_name(options, text);
}

int perform_rename(const EditOptions& options) {
  Run run;
  const auto file = text_of_file(run, options.graph);
  if (!file) return finish(run, options);
  const Change change = renamed(options, *file);
  const auto& edit = change.edit;
  if (!edit) {
    complain("error: {}\n", change.problem);
    if (!change.help.empty()) complain("help: {}\n", change.help);
    return kProblems;
  }
  const std::string text = applied(*file, edit->splices);
  const auto after = check_of(options, text);
  if (after->diagnostics.has_errors() && !check_of(options, *file)->diagnostics.has_errors()) {
    complain("error: `{}` stays as it is, for with the new name there would be a problem\n",
             options.graph);
    return finish(*after, options);
  }
  apply(run, options, *file, text);
  const int code = finish(run, options);
  if (code == kDone && !options.quiet && !options.dry_run)
    say("{}: {}, {}\n", options.graph, edit->reason, counted(edit->splices.size(), "place"));
  return code;
}

Arguments common(EditOptions& options, Argument file) {
  return {required(reads(std::move(file))),
          flag("--dry-run", options.dry_run, "print the changes, but do not write them"),
          library(options)};
}

Command fix_table(EditOptions& options) {
  return {
      .name = "fix",
      .about = "apply the suggested fixes of errors to graphs, manifests and settings of trainings",
      .examples = {{"show the changes only", "eagerx-gen fix pendulum.yaml --dry-run"},
                   {"change the file", "eagerx-gen fix pendulum.yaml"},
                   {"replace former names of settings", "eagerx-gen fix settings.yaml"},
                   {"all manifests of a folder", "eagerx-gen fix entities/*/manifest.yaml"}},
      .arguments =
          joined({common(options, texts("files", options.files, "files to change", "FILE.yaml")),
                  diagnostics(options)}),
      .run = [&options] { return perform_fix(options); }};
}

Command rename_table(EditOptions& options) {
  Arguments arguments =
      common(options, text("graph", options.graph, "file to change", "GRAPH.yaml"));
  arguments.insert(
      arguments.begin() + 1,
      {required(text("old", options.from,
                     "current name of an object, a node, an action or an observation", "OLD")),
       required(text("new", options.to, "new name", "NEW"))});
  return {.name = "rename",
          .about = "rename an object, a node, an action or an observation everywhere in a graph",
          .examples = {{"a node", "eagerx-gen rename pendulum.yaml smooth filter"},
                       {"an action", "eagerx-gen rename pendulum.yaml actions.voltage u"}},
          .arguments = joined({std::move(arguments), diagnostics(options)}),
          .run = [&options] { return perform_rename(options); }};
}

}  // namespace

Command fix_command() {
  return with_options<EditOptions>(fix_table);
}
Command rename_command() {
  return with_options<EditOptions>(rename_table);
}

}  // namespace eagerx::gen
