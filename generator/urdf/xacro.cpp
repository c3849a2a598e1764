// Macros of URDF files, which the program `xacro` expands.
#include <fmt/format.h>

#include "generator/support/process/process.hpp"
#include "generator/urdf/urdf.hpp"

namespace eagerx::urdf {

std::optional<std::string> expand_xacro(const std::string& path, gen::Span place,
                                        gen::Diagnostics& diagnostics) {
  const std::vector<std::string> command = {"xacro", path};
  if (gen::find_program(command[0]).empty()) {
    diagnostics
        .error("E0857", place,
               fmt::format("`{}` has macros of xacro, which is not installed", path))
        .help =
        "install `xacro` (ROS: `ros-DISTRO-xacro`; else `pipx install xacro`), or expand the "
        "file where there is one: `xacro FILE > robot.urdf`";
    return std::nullopt;
  }
  std::string text;
  gen::ProcessOptions options;
  options.line = [&text](std::string_view line) {
    text += line;
    text += '\n';
  };
  const auto result = gen::run_process(command, options);
  if (result && result->exit_code == 0) return text;
  // Once more, for what it says.
  const auto again = gen::run_process(command);
  diagnostics.error("E0857", place, fmt::format("xacro cannot expand `{}`", path))
      .notes.push_back({again ? again->output : "it cannot be started", {}, ""});
  return std::nullopt;
}

}  // namespace eagerx::urdf
