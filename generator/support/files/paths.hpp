// Absolute paths.
#pragma once

#include <filesystem>
#include <system_error>

namespace eagerx::gen {

/// The absolute path; unchanged if the working folder has been deleted, so that its use reports a
/// missing file.
inline std::filesystem::path absolute_path(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::path result = std::filesystem::absolute(path, error);
  return error ? path : result;
}

}  // namespace eagerx::gen
