#include "generator/driver/pipeline/paths.hpp"

#include <array>
#include <cstdlib>
#include <filesystem>

#include "generator/support/files/paths.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

bool is_root(const fs::path& folder) {
  std::error_code error;
  return fs::is_directory(folder / "models", error) &&
         fs::is_directory(folder / "templates", error);
}

}  // namespace

std::string data_root() {
  if (const char* home = std::getenv("EAGERX_HOME"); home != nullptr && *home != '\0') {
    return is_root(home) ? absolute_path(home).lexically_normal().string() : std::string();
  }
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const std::array candidates = {program.parent_path() / "../share/eagerx-gen",
                                 fs::path(EAGERX_BUILT_FROM)};
  for (const auto& candidate : candidates) {
    if (is_root(candidate)) return candidate.lexically_normal().string();
  }
  return {};
}

std::string package_folder() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  for (const fs::path& candidate :
       {program.parent_path() / "../share/cmake/eagerx_gen", program.parent_path()}) {
    if (fs::exists(candidate / "eagerx_gen-config.cmake", error))
      return candidate.lexically_normal().string();
  }
  return {};
}

std::string helper_program(const std::string& name) {
  std::error_code error;
  const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
  const fs::path installed = folder / "../libexec/eagerx-gen" / name;
  return (fs::exists(installed, error) ? installed : folder / name).lexically_normal().string();
}

std::string build_folder_of(const std::string& image, const std::string& said) {
  const std::string folder = std::filesystem::path(image).parent_path().string();
  return !said.empty() ? said : folder.empty() ? "." : folder;
}

std::string reference_folder() {
  std::error_code error;
  const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
  for (const fs::path& candidate : {folder / "../share/doc/eagerx-gen/html", folder / "site"}) {
    if (fs::exists(candidate / "index.html", error)) return candidate.lexically_normal().string();
  }
  return {};
}

}  // namespace eagerx::gen
