// eagerx-gen new board NAME: a folder to fill in.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "generator/cli/pipeline.hpp"
#include "generator/cli/write.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kBlank = ".blank";
constexpr std::string_view kPlaceholder = "BOARD_NAME";

bool is_board_name(std::string_view name) {
  const auto allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
  };
  return !name.empty() && name.front() >= 'a' && name.front() <= 'z' && name.back() != '-' &&
         std::ranges::all_of(name, allowed);
}

std::string with_name(std::string text, const std::string& name) {
  for (std::size_t at = text.find(kPlaceholder); at != std::string::npos;
       at = text.find(kPlaceholder, at + name.size()))
    text.replace(at, kPlaceholder.size(), name);
  return text;
}

/// The template's files, without their ending, in order of their names. Empty if there are none.
std::vector<std::pair<std::string, std::string>> filled_files(const fs::path& folder,
                                                              const std::string& name) {
  std::vector<std::pair<std::string, std::string>> result;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string file = entry.path().filename().string();
    if (!file.ends_with(kBlank)) continue;
    std::ifstream in(entry.path(), std::ios::binary);
    std::stringstream text;
    text << in.rdbuf();
    result.emplace_back(file.substr(0, file.size() - kBlank.size()), with_name(text.str(), name));
  }
  std::ranges::sort(result);
  return result;
}

void make_board(const fs::path& folder, const std::string& name, Run& run) {
  const auto files = filled_files(fs::path(run.root) / "targets" / "common" / "new-board", name);
  if (files.empty()) {
    run.diagnostics.io_error("E0301", {}, "cannot find the template of new boards");
    return;
  }
  std::error_code error;
  if (fs::exists(folder, error)) {
    run.diagnostics
        .io_error("E0902", {}, fmt::format("there is already something at `{}`", folder.string()))
        .help = "choose another name, or another folder with --output";
    return;
  }
  // Beside its place: a board without some of its files would not be taken for a broken one.
  const fs::path begun = folder.parent_path() / fmt::format(".{}.eagerx-gen.new", name);
  fs::remove_all(begun, error);  // of a run that was killed
  bool good = true;
  for (const auto& [file, text] : files)
    good = good && write_file((begun / file).string(), text, run.diagnostics);
  if (good) fs::rename(begun, folder, error);
  if (good && error)
    run.diagnostics.io_error("E0901", {},
                             fmt::format("cannot make `{}`: {}", folder.string(), error.message()));
  fs::remove_all(begun, error);
}

}  // namespace

int new_board_command(const Options& options) {
  Run run;
  load(run, options);
  if (!is_board_name(options.entity)) {
    run.diagnostics
        .error("E0303", {}, fmt::format("`{}` cannot be the name of a board", options.entity))
        .help = "use lower-case letters, digits and `-`, a letter first";
  } else if (run.library.targets.contains(options.entity)) {
    run.diagnostics.error("E0302", {},
                          fmt::format("there is already a target `{}`", options.entity));
  }
  if (run.diagnostics.has_errors()) return finish(run, options);
  const fs::path parent = options.output.empty() ? "targets" : options.output;
  const fs::path folder = parent / options.entity;
  make_board(folder, options.entity, run);
  if (!run.diagnostics.has_errors() && !options.quiet) {
    say("{0}: replace every FILL_IN, write the functions of board.cpp that are missing, then\n"
        "  eagerx-gen GRAPH.yaml --path {1} --target {2}\n"
        "or eagerx_add_graph(… BOARD {2} PATHS {1}). {3}/targets/README.md explains the rest.\n",
        folder.string(), parent.string(), options.entity, run.root);
  }
  return finish(run, options);
}

}  // namespace eagerx::gen
