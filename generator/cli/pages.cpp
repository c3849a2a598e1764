// eagerx-gen pages: manual pages and completions on disk. CMake calls it.
#include <fmt/format.h>

#include <filesystem>

#include "generator/cli/arguments.hpp"
#include "generator/cli/commands.hpp"
#include "generator/cli/pipeline.hpp"
#include "generator/cli/write.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

struct PagesOptions : MessageOptions {
  std::string folder;
};

int perform(const PagesOptions& options, const std::vector<CommandLinePage>& pages) {
  Run run;
  for (const CommandLinePage& page : pages) {
    const fs::path path = fs::path(options.folder) / page.path;
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
  return finish(run, options);
}

Command table(PagesOptions& options) {
  return {.name = "pages",
          .about = "write the manual pages and completions that are installed",
          .arguments = {required(folder(text("folder", options.folder, "where", "DIR")))},
          .hidden = true};
}

}  // namespace

Command pages_command(std::vector<CommandLinePage> (*pages)()) {
  Command command = with_options<PagesOptions>(table);
  command.run = [options = std::static_pointer_cast<PagesOptions>(command.options), pages] {
    return perform(*options, pages());
  };
  return command;
}

}  // namespace eagerx::gen
