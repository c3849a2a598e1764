// eagerx-urdf: a robot's description becomes an object for graphs.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <filesystem>

#include "generator/cli/commands.hpp"
#include "generator/cli/write.hpp"
#include "generator/diagnostics/pages.hpp"
#include "generator/urdf/robot.hpp"

namespace {

namespace fs = std::filesystem;
using eagerx::urdf::Base;

struct Options {
  std::string file, output;
  eagerx::urdf::RobotOptions robot;
  bool json = false, quiet = false;
};

bool is_id(const std::string& text) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  for (const char c : text) {
    if (!is_letter(c) && (c < '0' || c > '9')) return false;
  }
  return !text.empty() && is_letter(text[0]) && text != "Io";
}

void write(const Options& options, const eagerx::urdf::Robot& robot,
           eagerx::gen::Diagnostics& diagnostics) {
  const fs::path folder =
      options.output.empty() ? fs::path("entities") / robot.name : fs::path(options.output);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) {
    diagnostics.io_error("E0901", {},
                         fmt::format("cannot make `{}`: {}", folder.string(), error.message()));
    return;
  }
  if (!eagerx::gen::write_file((folder / "manifest.yaml").string(), manifest_text(robot),
                               diagnostics) ||
      !eagerx::gen::write_file((folder / (robot.name + ".hpp")).string(), header_text(robot),
                               diagnostics) ||
      options.quiet)
    return;
  std::printf("%s: %zu bodies, %zu joints, %zu shapes; written to %s\n", robot.id.c_str(),
              robot.bodies.size(), robot.joints.size(), robot.shapes.size(),
              folder.string().c_str());
}

int convert(const Options& options) {
  eagerx::gen::SourceMap sources;
  eagerx::gen::Diagnostics diagnostics;
  if (const auto description = eagerx::urdf::read_file(options.file, sources, diagnostics)) {
    const auto robot = eagerx::urdf::make_robot(*description, options.robot, diagnostics);
    if (robot) write(options, *robot, diagnostics);
  }
  diagnostics.sort_by_place();
  if (options.json) {
    static_cast<void>(std::fputs(render_json(diagnostics, sources).c_str(), stderr));
  } else if (!diagnostics.all().empty()) {
    const bool terminal = isatty(STDERR_FILENO) == 1;
    static_cast<void>(std::fputs(render_text(diagnostics, sources, terminal).c_str(), stderr));
    if (terminal) static_cast<void>(std::fputs(pointer_to_pages(diagnostics).c_str(), stderr));
  }
  if (diagnostics.has_io_errors()) return eagerx::gen::kInputOutput;
  return diagnostics.has_errors() ? eagerx::gen::kProblems : eagerx::gen::kDone;
}

int run(int argc, char** argv) {
  Options options;
  CLI::App app("Makes an object for OpenDynamicsEngine from a robot's URDF file.", "eagerx-urdf");
  app.footer(
      "Exit codes: 0 done, 1 problems found, 2 wrong usage, 3 cannot read or write, 4 a bug.");
  app.add_option("robot", options.file, "the description")->required()->type_name("ROBOT.urdf");
  app.add_option("-o,--output", options.output, "folder to write (default: entities/<robot>)")
      ->type_name("DIR");
  app.add_option("--id", options.robot.id, "what graphs call it (default: from the robot's name)")
      ->check(CLI::Validator(
          [](const std::string& text) {
            return is_id(text) ? std::string() : text + " is not made of letters and digits";
          },
          ""))
      ->type_name("NAME");
  app.add_option_function<std::string>(
         "--base",
         [&](const std::string& word) {
           options.robot.base = word == "fixed" ? Base::fixed : Base::free;
         },
         "whether the first link is part of the world or free (default: free if it has an "
         "`inertial`)")
      ->check(CLI::IsMember({"fixed", "free"}).description(""))
      ->type_name("fixed|free");
  app.add_flag("--ground", options.robot.ground, "add the plane z = 0");
  app.add_option_function<std::string>(
         "--diagnostics", [&](const std::string& form) { options.json = form == "json"; },
         "form of messages (default: text)")
      ->check(CLI::IsMember({"text", "json"}).description(""))
      ->type_name("text|json");
  app.add_flag("-q,--quiet", options.quiet, "print problems only");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? eagerx::gen::kDone : eagerx::gen::kWrongUsage;
  }
  return convert(options);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    static_cast<void>(std::fprintf(stderr, "error: a bug in eagerx-urdf: %s\n", error.what()));
    return eagerx::gen::kInternal;
  }
}
