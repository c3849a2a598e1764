// Files that programs write for their users. Errors are values of errno, 0 if there is none.
#pragma once

#include <sys/stat.h>

#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>

namespace eagerx::host {

/// Whether written data is on the disk, or may still be cached.
enum class Durability : std::uint8_t { synced, cached };

/// A file that is written completely or not at all. It is written next to the file that `path`
/// resolves to, with a new random name, and with owner and mode of the file it replaces. Targets
/// that cannot be replaced are written in place: a device, a FIFO, a file of another owner, or one
/// in a folder that accepts no new files. A file without write permission is rejected, for root
/// too.
class AtomicFile {
 public:
  explicit AtomicFile(std::string path);
  /// Removes a draft without put().
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  const std::string& path() const { return path_; }
  /// Keeps all of `bytes` until put().
  [[nodiscard]] int write(std::string_view bytes, Durability durability = Durability::synced);
  /// Makes an empty file that another program writes: name(), which ends with `ending`.
  [[nodiscard]] int make(std::string_view ending);
  const std::string& name() const { return draft_.empty() ? path_ : draft_; }
  /// Replaces the file with the written one.
  [[nodiscard]] int put();
  /// The same only where the file has the text `expected` (nothing: where no file is). ECANCELED:
  /// it has another one, which stays. The two are exchanged, and back again if another program was
  /// faster, so that no save is lost.
  [[nodiscard]] int put_over(const std::optional<std::string>& expected);

 private:
  int begin(std::string_view ending, int& file);
  int make_next_to(const struct stat* replaced, std::string_view ending, int& file);
  int exchange(const std::optional<std::string>& expected);
  int write_into();

  std::string path_;
  std::string place_;     // where the links of path_ lead
  std::string draft_;     // next to it, while it exists
  std::string bytes_;     // for what is written into
  bool is_made_ = false;  // and written by another program
};

/// write() and put().
[[nodiscard]] int write_whole(const std::string& path, std::string_view bytes,
                              Durability durability = Durability::synced);

/// Removes the drafts of `path` that killed programs left behind. An AtomicFile does this itself.
void remove_left_drafts(const std::string& path);

/// The path after resolving all links, which need not exist.
std::string behind_links(const std::string& path);

/// The file that a AtomicFile of `path` would replace. Changes nothing, and opens no device and no
/// FIFO.
[[nodiscard]] int problem_of_output(const std::string& path);

/// Whether an AtomicFile replaces the target. Other targets, such as a FIFO, are written in place.
bool is_replaced_by_output(const std::string& path);

/// Whether something of this kind is written at all: no folder, socket or disk, and no file that
/// is not writable, although root could write it.
bool takes_output(const struct stat& status);

/// Why a file cannot be written.
std::string problem_of_writing(int error);

/// For programs that read a file, change it and put a AtomicFile in its place: one at a time.
class FileLock {
 public:
  /// Waits up to ten seconds. `makes`: creates an empty file if there is none.
  explicit FileLock(const std::string& path, bool makes = true);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;
  /// EWOULDBLOCK: others have had it all the time.
  int error() const { return error_; }

 private:
  int take(const std::string& path, bool makes);

  int file_ = -1;
  int error_ = 0;
};

/// Whether it is /dev/null, for unwanted output.
bool is_dev_null(const struct stat& status);

/// Opens descriptors 0 to 2 on /dev/null where they are closed, so that no other file becomes one
/// of them. A closed standard output stays one that cannot be written.
void open_standard_files();

/// Writes `text` to `out`, all of it, now.
[[nodiscard]] int print(std::FILE* out, std::string_view text);

}  // namespace eagerx::host
