#include "generator/analysis/size/program_file.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <runtime/host/base/hash.hpp>
#include <sstream>

namespace eagerx::gen {
namespace {

std::optional<std::string> text_of_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return file ? std::optional(text.str()) : std::nullopt;
}

}  // namespace

std::optional<ProgramMap> map_of_program(const std::string& program, const std::string& image,
                                         Diagnostics& diagnostics) {
  const std::string path = std::filesystem::path(program).replace_extension(".map").string();
  const auto text = text_of_file(program), map_text = text_of_file(path);
  if (!text || !map_text) {
    diagnostics
        .io_error("E0911", {},
                  fmt::format("cannot read `{}`, which says what of `{}` belongs to which node",
                              text ? path : program, image))
        .help = "keep what `eagerx-gen generate` wrote where the image was built from it";
    return std::nullopt;
  }
  auto map = parse_program_map(*map_text, path, diagnostics);
  if (!map) return std::nullopt;
  if (map->program_hash != host::fnv1a(*text)) {
    diagnostics
        .io_error("E0911", {}, fmt::format("`{}` was not made with this `{}`", path, program))
        .help = "generate the program again and build it anew; do not edit program.hpp";
    return std::nullopt;
  }
  return map;
}

}  // namespace eagerx::gen
