// A folder whose files are read, written and removed without following a path out of it.
#pragma once

#include <cerrno>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace eagerx::gen {

/// An open file or folder.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor();

  explicit operator bool() const { return number_ >= 0; }
  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

/// Whether a path is below the folder that it is relative to, by its text: `a/b.hpp`. There are no
/// line breaks in such a path: lists of them have a line for each.
bool is_below(std::string_view path);

/// Paths are below the folder (is_below()). The folders in them must not be links, and links are
/// never followed. A function that fails sets `errno`.
class Folder {
 public:
  enum class Kind { nothing, file, folder, other };

  /// The folder, which may be reached through links; made if it is not there.
  static std::optional<Folder> open(const std::string& path);

  /// Waits until no other process has it, at most 10 s; not if this one keeps it.
  [[nodiscard]] bool lock() const;
  /// The kind of the path's entry; `other`: a link, a device, or an entry that cannot be inspected.
  [[nodiscard]] Kind kind(const std::string& path) const;
  /// The text of a file; nullopt if it is missing or cannot be read.
  [[nodiscard]] std::optional<std::string> read(const std::string& path) const;
  /// Makes a file that is not there yet, and the folders that it is in.
  [[nodiscard]] bool write_new(const std::string& path, std::string_view text) const;
  /// Renames a file, into folders that are made.
  [[nodiscard]] bool rename(const std::string& from, const std::string& to) const;
  /// Removes a file or link, and the folders of its path that are empty then.
  [[nodiscard]] bool remove(const std::string& path) const;
  /// Removes a folder, and its parents while they are empty.
  void remove_empty(std::string path) const;
  /// Names in a folder below this one, sorted.
  [[nodiscard]] std::vector<std::string> names(const std::string& path) const;
  /// Whether a file may be put there: the folders of its path that exist are folders one may write.
  [[nodiscard]] bool takes(const std::string& path) const;

 private:
  friend class KeptFolders;
  explicit Folder(Descriptor descriptor) : self_(std::move(descriptor)) {}
  [[nodiscard]] bool is_kept() const;
  /// The folder that a path's last name is in.
  [[nodiscard]] Descriptor parent(const std::string& path, bool make) const;

  Descriptor self_;
};

/// Locks folders, so that no other process writes or builds there until this one ends or executes
/// the built program: no process gets a program built with the options of another.
class KeptFolders {
 public:
  /// Creates the folder, and waits up to ten minutes for its lock, because builds take long; calls
  /// `waiting` once after a second. False: see errno; EWOULDBLOCK if another process still has the
  /// lock.
  static bool keep(const std::string& path, const std::function<void()>& waiting);
  /// For a program that this process executes and that opens the built files itself: keeps the
  /// descriptors open in it. "5,7"
  static std::string hand_on();

 private:
  friend class Folder;
  static std::vector<Folder>& all();
};

}  // namespace eagerx::gen
