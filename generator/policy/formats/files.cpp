#include "generator/policy/formats/files.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "generator/policy/network/limits.hpp"
#include "generator/support/files/files.hpp"
#include "generator/support/files/missing_file.hpp"

namespace eagerx::gen {

void report_problem(const PolicyProblem& problem, const char* what, const std::string& name,
                    Span mention, Diagnostics& diagnostics) {
  diagnostics.error(problem.code, mention, fmt::format("{} `{}` {}", what, name, problem.message))
      .help = problem.help;
}

std::optional<std::string> read_bytes(const std::string& path, const std::string& name,
                                      Span mention, const char* what, Diagnostics& diagnostics) {
  const auto unreadable = [&](const std::string& why) {
    diagnostics.io_error("E0601", mention, fmt::format("cannot read {} `{}`: {}", what, name, why))
        .help = help_for_missing(path, name);
    return std::nullopt;
  };
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) return unreadable("no such file");
  if (!std::filesystem::is_regular_file(status)) return unreadable("not a regular file");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) return unreadable(error.message());
  if (size > kMaxPolicyBytes) {
    diagnostics.error("E0602", mention,
                      fmt::format("{} `{}` has {} bytes; at most {} are read", what, name, size,
                                  kMaxPolicyBytes));
    return std::nullopt;
  }
  remember_input(path);
  std::ifstream file(path, std::ios::binary);
  if (!file) return unreadable(std::error_code(errno, std::generic_category()).message());
  std::string bytes(static_cast<std::size_t>(size), '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(size));
  if (!file) return unreadable("the file ended early");
  return bytes;
}

FilesInFolder files_in_folder_of(const std::string& path) {
  return [path](const std::string& name, std::string& why) -> std::optional<std::string> {
    const std::filesystem::path file = std::filesystem::path(path).parent_path() / name;
    std::error_code error;
    if (std::filesystem::is_symlink(file, error)) {
      why = "which is a link";
      return std::nullopt;
    }
    Diagnostics found;
    auto bytes = read_bytes(file.string(), name, {}, "values", found);
    if (!bytes) why = "which is not there, cannot be read, or is too large";
    return bytes;
  };
}

}  // namespace eagerx::gen
