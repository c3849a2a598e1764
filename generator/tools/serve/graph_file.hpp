// The graph's file on the disk, which others may change at any time.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace eagerx::gen::serve {

/// The result of reading: the text, or why there is none.
struct FileText {
  std::string text;
  bool exists = false;
  std::string problem = {};  // it is there and cannot be read: a folder, too large, no permission
};

class GraphFile {
 public:
  static constexpr std::size_t kMostBytes = 16U << 20U;

  /// `path` may be a link: what it leads to is written.
  explicit GraphFile(std::string path);

  [[nodiscard]] FileText read(std::size_t most_bytes = kMostBytes) const;
  /// Cheap: whether the file may be another one than at the last read() or write() with this
  /// object. It may be so without need.
  [[nodiscard]] bool may_have_changed() const;

  enum class Written : unsigned char { done, changed, failed };
  /// Puts `text` where `expected` is (nothing: where no file is). It is written under a temporary
  /// name and exchanged with the file; if what was there is not `expected`, the two are exchanged
  /// back: `changed`. `failed`: problem() says why, and nothing was changed.
  Written write(const std::optional<std::string>& expected, const std::string& text);
  [[nodiscard]] const std::string& problem() const { return problem_; }

  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  struct Stamp {
    long long device = 0, inode = 0, size = -1, modified_ns = 0, changed_ns = 0;
    bool operator==(const Stamp&) const = default;
  };
  [[nodiscard]] Stamp stamp() const;

  std::string path_, problem_;
  mutable Stamp seen_;
};

}  // namespace eagerx::gen::serve
