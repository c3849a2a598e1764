// eagerx-urdf: converts a robot's description into an object for graphs.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string_view>

#include "generator/driver/build/write.hpp"
#include "generator/driver/commands/pages.hpp"
#include "generator/frontend/read/scalar.hpp"
#include "generator/support/command_line/bugs.hpp"
#include "generator/support/command_line/command_line.hpp"
#include "generator/support/command_line/output.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/pages.hpp"
#include "generator/urdf/meshes.hpp"
#include "generator/urdf/robot.hpp"

namespace {

namespace fs = std::filesystem;
using eagerx::urdf::Base;

struct Options {
  std::string file, output, distance, facets;
  eagerx::urdf::RobotOptions robot;
  eagerx::urdf::MeshOptions meshes;
  bool json = false, quiet = false;
};

bool is_id(const std::string& text) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  for (const char c : text) {
    if (!is_letter(c) && (c < '0' || c > '9')) return false;
  }
  return !text.empty() && is_letter(text[0]) && text != "Io";
}

constexpr double kUsualStep = 1e-3;  // [s]

/// Notes on what the description leaves open.
void say_more(const Options& options, const eagerx::urdf::Robot& robot) {
  // A robot that was meant to stand on something falls.
  if (options.robot.base == Base::by_mass && !robot.bodies.empty() && !robot.has_world) {
    if (robot.bodies[0].is_free)
      eagerx::gen::say("`{}` is free to move, as it has a mass: `--base fixed` fixes it\n",
                       robot.base);
    else
      eagerx::gen::say("`{}` is fixed to the world, as it has no mass\n", robot.base);
  }
  if (robot.links > robot.bodies.size())
    eagerx::gen::say("{} of {} links: the others are welded to them, or to the world\n",
                     eagerx::gen::counted(robot.bodies.size(), "body", "bodies"), robot.links);
  if (const auto quick = quickest_joint(robot); quick && quick->time_s < kUsualStep)
    eagerx::gen::say(
        "`{}` reaches {:.3g} rad/s or m/s in {:.2g} ms under its largest torque: longer steps do "
        "not "
        "follow it; is its inertia, or its `limit`, right?\n",
        quick->name, quick->speed, 1e3 * quick->time_s);
  if (!can_use_open_dynamics(robot))
    eagerx::gen::say(
        "for MultibodyEngine alone: OpenDynamicsEngine has no joints that mimic others\n");
  if (!can_use_multibody(robot))
    eagerx::gen::say(
        "for OpenDynamicsEngine alone: MultibodyEngine has one free body, or joints on the "
        "world, and one plane, in each object\n");
}

void write(const Options& options, const eagerx::urdf::Robot& robot,
           eagerx::gen::Diagnostics& diagnostics) {
  const fs::path folder =
      options.output.empty() ? fs::path("entities") / robot.name : fs::path(options.output);
  const auto written = eagerx::gen::write_files(
      folder.string(),
      {{"manifest.yaml", manifest_text(robot)}, {robot.name + ".hpp", header_text(robot)}},
      diagnostics);
  if (!written || options.quiet) return;
  eagerx::gen::say("{}: {}, {}, {}; written to {}\n", robot.id,
                   eagerx::gen::counted(robot.bodies.size(), "body", "bodies"),
                   eagerx::gen::counted(robot.joints.size(), "joint"),
                   eagerx::gen::counted(robot.shapes.size(), "shape"), folder.string());
  say_more(options, robot);
}

int convert(const Options& options) {
  eagerx::gen::SourceMap sources;
  eagerx::gen::Diagnostics diagnostics;
  if (auto description = eagerx::urdf::read_file(options.file, sources, diagnostics)) {
    resolve_meshes(*description, fs::path(options.file).parent_path().string(), options.meshes,
                   diagnostics);
    eagerx::urdf::RobotOptions robot_options = options.robot;
    if (description->has_world && options.robot.base != Base::by_mass) {
      set_base(*description, options.robot.base == Base::free);
      robot_options.base = Base::by_mass;
    }
    const auto robot = eagerx::urdf::make_robot(*description, robot_options, diagnostics);
    if (robot) write(options, *robot, diagnostics);
  }
  if (options.quiet) diagnostics.drop_notes();
  diagnostics.drop_repeats();
  diagnostics.sort_by_place();
  if (options.json) {
    static_cast<void>(std::fputs(render_json(diagnostics, sources).c_str(), stderr));
  } else if (!diagnostics.all().empty()) {
    const bool terminal = isatty(STDERR_FILENO) == 1;
    static_cast<void>(std::fputs(render_text(diagnostics, sources, terminal).c_str(), stderr));
    if (terminal) static_cast<void>(std::fputs(pointer_to_pages(diagnostics).c_str(), stderr));
  }
  if (diagnostics.has_usage_errors()) return eagerx::gen::kWrongUsage;
  if (diagnostics.has_io_errors()) return eagerx::gen::kInputOutput;
  return diagnostics.has_errors() ? eagerx::gen::kProblems : eagerx::gen::kDone;
}

eagerx::gen::CommandLine command_line(Options& options) {
  using eagerx::gen::choice;
  using eagerx::gen::flag;
  using eagerx::gen::text;
  using eagerx::gen::texts;
  eagerx::gen::Argument id =
      text("--id", options.robot.id, "id of the object (default: from the robot's name)", "NAME");
  id.check = [](const std::string& name) {
    return is_id(name) ? std::string() : name + " is not made of letters and digits";
  };
  eagerx::gen::Argument distance =
      text("--distance", options.distance,
           "maximum distance of the spheres of `--collision spheres` beyond a mesh (default: 0.01)",
           "METERS");
  distance.check = [&options](const std::string& written) {
    const auto value = eagerx::gen::parse_number(written);
    if (!value || !(*value > 0.0)) return written + " is not a length above 0";
    options.meshes.distance = *value;
    return std::string();
  };
  eagerx::gen::Argument facets =
      text("--facets", options.facets,
           "triangles that draw the visual meshes, up to 900 (default: 400; 0 draws the collision "
           "shapes)",
           "COUNT");
  facets.check = [&options](const std::string& written) {
    const auto value = eagerx::gen::parse_number(written);
    if (!value || !(*value >= 0.0) || *value > 900.0 || *value != std::floor(*value))
      return written + " is not a whole number from 0 to 900";
    options.meshes.facets = static_cast<std::size_t>(*value);
    return std::string();
  };
  const auto set_base = [&options](const std::string& word) {
    options.robot.base = word == "fixed" ? Base::fixed : Base::free;
  };
  const auto set_shapes = [&options](const std::string& word) {
    using eagerx::urdf::CollisionShapes;
    options.meshes.shapes = word == "none"    ? CollisionShapes::none
                            : word == "boxes" ? CollisionShapes::boxes
                                              : CollisionShapes::spheres;
  };
  const auto set_form = [&options](const std::string& form) { options.json = form == "json"; };
  return {
      .top = {.name = "eagerx-urdf",
              .about = "Makes an object for OpenDynamicsEngine and MultibodyEngine from a robot's "
                       "URDF or MJCF (MuJoCo) file.",
              .arguments =
                  {required(
                       reads(text("robot", options.file,
                                  "description of the robot: URDF, xacro or MJCF", "ROBOT.urdf"))),
                   folder(text("-o,--output", options.output,
                               "output folder (default: entities/<robot>)", "DIR")),
                   std::move(id),
                   choice("--base", {"fixed", "free"},
                          "fix the first link to the world, or let it move (default: free if the "
                          "link, or one fixed to it, has a mass; for MJCF, as in the file)",
                          set_base),
                   choice("--collision", {"none", "boxes", "spheres"},
                          "collision shapes of meshes: none, boxes, or up to 16 spheres (default: "
                          "the smallest of box, sphere, cylinder and capsule)",
                          set_shapes),
                   std::move(distance), std::move(facets),
                   texts("--package", options.meshes.packages,
                         "folder to search for `package://`, in addition to the folders above the "
                         "file; may be repeated",
                         "DIR"),
                   flag("--ground", options.robot.ground, "add the plane z = 0"),
                   choice("--diagnostics", {"text", "json"}, "format of messages (default: text)",
                          set_form),
                   flag("-q,--quiet", options.quiet, "print problems only")},
              .run = [&options] { return convert(options); }},
      .footer =
          "Exit codes: 0 done, 1 problems found, 2 wrong usage, 3 cannot read or write, 4 a bug."};
}

}  // namespace

int main(int argc, char** argv) {
  return eagerx::gen::reporting_bugs("eagerx-urdf", [&] {
    Options options;
    if (argc == 3 && std::string_view(argv[1]) == "--pages")  // CMake calls it
      return eagerx::gen::write_pages(argv[2], command_line_pages(command_line(options)));
    return eagerx::gen::run_command_line(
        command_line(options), std::vector<std::string>(argv + std::min(argc, 1), argv + argc));
  });
}
