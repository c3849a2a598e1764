// eagerx-gen pages: manual pages and completions on disk. CMake calls it.
#include <fmt/format.h>

#include <filesystem>

#include "generator/cli/pipeline.hpp"
#include "generator/cli/write.hpp"

namespace eagerx::gen {

int pages_command(const Options& options, const std::vector<CommandLinePage>& pages) {
  namespace fs = std::filesystem;
  Run run;
  for (const CommandLinePage& page : pages) {
    const fs::path path = fs::path(options.output) / page.path;
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

}  // namespace eagerx::gen
