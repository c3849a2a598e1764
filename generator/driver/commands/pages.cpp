// eagerx-gen pages: manual pages and completions on disk. CMake calls it.
#include "generator/driver/commands/pages.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "generator/driver/build/write.hpp"
#include "generator/driver/commands/arguments.hpp"
#include "generator/driver/commands/commands.hpp"
#include "generator/driver/pipeline/pipeline.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

struct PagesOptions {
  std::string folder;
  std::vector<CommandLinePage> (*pages)() = nullptr;
};

Command table(PagesOptions& options) {
  return {.name = "pages",
          .about = "write the manual pages and completions that are installed",
          .arguments = {required(folder(text("folder", options.folder, "where", "DIR")))},
          .run = [&options] { return write_pages(options.folder, options.pages()); },
          .hidden = true};
}

}  // namespace

int write_pages(const std::string& folder, const std::vector<CommandLinePage>& pages) {
  Run run;
  for (const CommandLinePage& page : pages) {
    const fs::path path = fs::path(folder) / page.path;
    std::error_code error;
    fs::create_directories(path.parent_path(), error);
    if (error) {
      run.diagnostics.io_error(
          "E0901", {},
          fmt::format("cannot make `{}`: {}", path.parent_path().string(), error.message()));
      break;
    }
    if (!write_file(path.string(), page.text, run.diagnostics)) break;
  }
  return finish(run, {});
}

Command pages_command(std::vector<CommandLinePage> (*pages)()) {
  return with_options<PagesOptions>(table, {{}, pages});
}

}  // namespace eagerx::gen
