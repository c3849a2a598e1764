#include "generator/driver/commands/next_steps.hpp"

#include <fmt/format.h>

#include "generator/analysis/info/info.hpp"
#include "generator/driver/build/built.hpp"
#include "generator/driver/build/emitted.hpp"
#include "generator/support/quote/quote.hpp"

namespace eagerx::gen {
namespace {

class Steps {
 public:
  Steps(const Run& run, const GenerateOptions& options) : run_(run), options_(options) {}

  /// Configures, builds and starts one program. `several`: others lie in the same folder.
  std::string build(const Target& target, const std::string& folder, bool several) const {
    const Tree tree = tree_of(run_, options_, target, folder, several);
    std::string line =
        fmt::format("  cmake -S {} -B {}", shell_word(folder), shell_word(tree.build));
    if (!tree.toolchain.empty()) line += " --toolchain " + shell_word(tree.toolchain);
    for (const auto& [name, value] : tree.settings)
      line += fmt::format(" -D {}={}", name, shell_word(value));
    return line + fmt::format(" && cmake --build {}", shell_word(tree.build)) +
           start(target, tree.build) + "\n";
  }

 private:
  /// Nothing where the manifest does not say how.
  [[nodiscard]] std::string start(const Target& target, const std::string& build) const {
    std::string text;
    for (const std::string& word :
         command_to_start(run_, {&target, build, image_of(run_, target, build)}))
      text += (text.empty() ? " && " : " ") + shell_word(word);
    return text.empty() || target.system.empty() ? text : text + " --help";
  }

  const Run& run_;
  const GenerateOptions& options_;
};

/// "the part on stm32f405", "part `vision` for linux-sim, on camera_pc"
std::string described(const PlacedPart& part) {
  if (part.name == "board") return "the part on " + part.target->id.value;
  return fmt::format("part `{}` for {}{}{}", part.name, part.target->id.value,
                     part.host.empty() ? "" : ", on ", part.host);
}

}  // namespace

std::string next_steps(const Run& run, const GenerateOptions& options,
                       const std::vector<const Target*>& targets, const std::string& folder) {
  if (options.makes_library()) {
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
    const auto& parts = run.graph->placement->parts;
    for (std::size_t part = 0; part < parts.size(); ++part) {
      const std::string own = folder + "/" + parts[part].name;
      if (!is_compiled(*parts[part].target)) {
        text += fmt::format("start {}; over its link in a step: {}:\n  {} {} --listen unix:PATH\n",
                            described(parts[part]), load_of_part(*run.plan, part),
                            parts[part].target->run.front(), shell_word(own));
        continue;
      }
      Target target = *parts[part].target;
      target.run.clear();  // it waits for its hub
      text += fmt::format("build {}; over its link in a step: {}:\n{}", described(parts[part]),
                          load_of_part(*run.plan, part), steps.build(target, own, false));
    }
  }
  text += split ? "build the rest; its --help says how to name the parts' lines:\n"
                : "build and run it:\n";
  for (const Target* target : targets)
    text += steps.build(*target, split ? folder + "/" + kHubFolder : folder, targets.size() > 1);
  return text;
}

}  // namespace eagerx::gen
