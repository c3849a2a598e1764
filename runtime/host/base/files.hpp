// Files that are there as a whole or not at all. Errors are those of errno, 0 without one.
#pragma once

#include <sys/stat.h>

#include <cstdio>
#include <string>
#include <string_view>

namespace eagerx::host {

/// What takes the place of the file `path` once it is complete: `path`.part, beside it.
class Draft {
 public:
  explicit Draft(std::string path);
  /// Removes what was not put.
  ~Draft();
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;

  const std::string& path() const { return path_; }
  /// Writes all of `bytes` down to the disk.
  [[nodiscard]] int write(std::string_view bytes);
  /// From now on the file is what was written.
  [[nodiscard]] int put();

 private:
  std::string path_;
  std::string draft_;
  bool is_there_ = false;
};

/// Both.
[[nodiscard]] int write_whole(const std::string& path, std::string_view bytes);

/// Where people send what they do not want: it may be an output, as no other device may.
bool is_dev_null(const struct stat& status);

/// Writes `text` to `out`, all of it, now.
[[nodiscard]] int print(std::FILE* out, std::string_view text);

}  // namespace eagerx::host
