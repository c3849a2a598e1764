#include "generator/cli/next_steps.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "generator/quote/quote.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

class Steps {
 public:
  Steps(const Run& run, const Options& options) : run_(run), options_(options) {}

  /// Configures, builds and starts one program. `several`: others lie in the same folder.
  std::string build(const Target& target, const std::string& folder, bool several) const {
    const std::string tree = folder + (several ? "/build-" + target.id.value : "/build");
    std::string line = fmt::format("  cmake -S {} -B {}", shell_word(folder), shell_word(tree));
    if (several) line += " -D EAGERX_TARGET=" + shell_word(target.id.value);
    if (!target.toolchain.empty()) line += " --toolchain " + shell_word(toolchain(target, folder));
    if (is_own(target) && !standalone())
      line += " -D EAGERX_TARGETS_PATH=" +
              shell_word(fs::absolute(folder_of(target)).lexically_normal().parent_path().string());
    return line + fmt::format(" && cmake --build {}", shell_word(tree)) + start(target, tree) +
           "\n";
  }

 private:
  [[nodiscard]] bool standalone() const {
    return options_.standalone || !options_.packages.empty();
  }

  [[nodiscard]] fs::path folder_of(const Target& target) const {
    return fs::path(run_.sources.name(target.id.span.file)).parent_path();
  }

  [[nodiscard]] bool is_own(const Target& target) const {
    return folder_of(target).parent_path() != fs::path(run_.root) / "targets";
  }

  [[nodiscard]] std::string toolchain(const Target& target, const std::string& folder) const {
    if (standalone()) return folder + "/eagerx-gen/toolchains/" + target.toolchain;
    for (const auto& path : options_.paths) {
      std::error_code error;
      const fs::path own = fs::path(path) / "toolchains" / target.toolchain;
      if (fs::exists(own, error)) return own.string();
    }
    return (fs::path(run_.root) / "toolchains" / target.toolchain).string();
  }

  /// Nothing where the manifest does not say how.
  [[nodiscard]] std::string start(const Target& target, const std::string& tree) const {
    const std::string image = tree + "/" + run_.graph->name;
    if (target.run.empty()) return {};
    if (target.toolchain.empty()) return " && " + shell_word(image) + " --help";
    const std::string name = is_own(target) ? folder_of(target).string() : target.id.value;
    return fmt::format(
        " && {} {} {}", shell_word((fs::path(run_.root) / "targets" / "run").string()),
        shell_word(name),
        target.system.empty() ? shell_word(image + ".elf") : shell_word(image) + " --help");
  }

  const Run& run_;
  const Options& options_;
};

std::string link_text(const Run& run) {
  const Split& split = *run.plan->split;
  if (split.exchanges == 0.0) return {};
  // As the frames are: eagerx/link/frame.hpp.
  constexpr double kFrame = 12.0;
  constexpr double kBitsOfAByte = 10.0;
  constexpr double kBaud = 115200.0;
  const double bytes = split.board_bytes + split.host_bytes + 2 * kFrame * split.exchanges;
  return fmt::format(
      "link: {:.4g} exchanges a step, {:.4g} bytes of messages to the board and {:.4g} back; "
      "{:.3g} of {:.3g} ms at 115200 baud\n",
      split.exchanges, split.board_bytes, split.host_bytes, 1e3 * kBitsOfAByte * bytes / kBaud,
      1e3 / run.graph->environment().rate_hz.to_double());
}

}  // namespace

std::string next_steps(const Run& run, const Options& options,
                       const std::vector<const Target*>& targets, const std::string& folder) {
  if (options.library) {
    return fmt::format(
        "in the CMakeLists.txt of your program:\n  add_subdirectory({0} {0}.build)\n"
        "  target_link_libraries(your_program PRIVATE {1})\n"
        "{0}/{2}{1}.hpp says how to use it\n",
        folder, run.graph->name, options.standalone || !options.packages.empty() ? "src/" : "");
  }
  const Steps steps(run, options);
  const bool split = run.graph->placement.has_value();
  std::string text;
  if (split) {
    Target board = *run.graph->placement->board;
    board.run.clear();  // it waits for its host
    text += fmt::format("{}build the part on {}:\n{}", link_text(run), board.id.value,
                        steps.build(board, folder + "/board", false));
  }
  text +=
      split ? "build the rest; its --help says how to name the board:\n" : "build and run it:\n";
  for (const Target* target : targets)
    text += steps.build(*target, split ? folder + "/host" : folder, targets.size() > 1);
  return text;
}

}  // namespace eagerx::gen
