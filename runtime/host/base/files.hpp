// Files that programs write for their users. Errors are values of errno, 0 if there is none.
#pragma once

#include <sys/stat.h>

#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>

namespace eagerx::host {

/// Whether what is written is on the disk, or on its way there.
enum class Durability : std::uint8_t { synced, cached };

/// A file that is there as a whole or not at all. It is written next to the one that `path` leads
/// to by links, with a random name that nothing had, and with owner and mode of the one it
/// replaces. What cannot be replaced so is written into: a device, a FIFO, a file of another owner
/// or in a folder that takes no new files. A file without write permission is refused, for root
/// too.
class AtomicFile {
 public:
  explicit AtomicFile(std::string path);
  /// Removes what was not put.
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  const std::string& path() const { return path_; }
  /// Keeps all of `bytes` until put().
  [[nodiscard]] int write(std::string_view bytes, Durability durability = Durability::synced);
  /// Makes an empty file that another program writes: name(), which ends with `ending`.
  [[nodiscard]] int make(std::string_view ending);
  const std::string& name() const { return draft_.empty() ? path_ : draft_; }
  /// From now on the file is what was written.
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

/// Removes the drafts of `path` that killed programs left behind. A AtomicFile does so itself.
void remove_left_drafts(const std::string& path);

/// The name behind all links, where there may be nothing yet.
std::string behind_links(const std::string& path);

/// The file that a AtomicFile of `path` would replace. Changes nothing, and opens no device and no
/// FIFO.
[[nodiscard]] int problem_of_output(const std::string& path);

/// Whether a AtomicFile replaces what is there. Into anything else, such as a FIFO, all is written
/// once.
bool is_replaced_by_output(const std::string& path);

/// Whether something of this kind is written at all: no folder, socket or disk, and no file that
/// is not writable, although root could write it.
bool takes_output(const struct stat& status);

/// Why a file cannot be written.
std::string problem_of_writing(int error);

/// For programs that read a file, change it and put a AtomicFile in its place: one at a time.
class FileLock {
 public:
  /// Waits for at most ten seconds. `makes`: an empty file if there is none.
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

/// Where people send what they do not want.
bool is_dev_null(const struct stat& status);

/// Opens descriptors 0 to 2 on /dev/null where they are closed, so that no other file becomes one
/// of them. A closed standard output stays one that cannot be written.
void open_standard_files();

/// Writes `text` to `out`, all of it, now.
[[nodiscard]] int print(std::FILE* out, std::string_view text);

}  // namespace eagerx::host
