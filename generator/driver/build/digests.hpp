// Digests of a build's files from the time of compilation.
#pragma once

#include <cstdint>
#include <ctime>
#include <map>
#include <string>
#include <vector>

namespace eagerx::gen {

/// CMake's build tools compare times: a file that is replaced by one with an older time, as cp -p,
/// rsync and tar do, is not compiled again. This compares contents.
class Digests {
 public:
  /// Of a build folder, as they were kept there.
  explicit Digests(std::string build);

  /// Whether one of the files has changed without a time stamp that build tools notice, one after
  /// `last_build`.
  [[nodiscard]] bool have_unseen_change(const timespec& last_build) const;
  /// The digests of all files compiled so far, as text to store. `listed`: the output of `ninja -t
  /// deps`.
  [[nodiscard]] std::string now(const std::string& listed) const;

 private:
  struct File {
    std::int64_t inode = 0, size = 0, changed_ns = 0;
    std::uint64_t digest = 0;
  };
  [[nodiscard]] std::string place_of(const std::string& path) const;
  [[nodiscard]] bool look(const std::string& path, File& file, timespec& modified) const;

  std::string build_;
  std::map<std::string, File> files_;
};

/// The compiled files, as `ninja -t deps` prints it, of a build folder of Make: from the files
/// `*.d` that compilers write next to object files.
std::string listed_in_depfiles(const std::string& build);

/// The file in the build folder that has them.
inline constexpr const char* kDigests = "eagerx-gen.digests";

}  // namespace eagerx::gen
