#include "generator/support/files/files.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <mutex>
#include <span>
#include <utility>

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

struct Named {
  std::string path;
  std::string name;
};

/// Policies may be read by several threads.
struct Known {
  std::mutex mutex;
  std::vector<Named> inputs, outputs;
};
Known& known() {
  static Known files;
  return files;
}

/// A file, by what the file system calls it, or while there is none by where it will be.
class Place {
 public:
  explicit Place(const std::string& path) {
    std::error_code ignored;
    there_ = stat(path.c_str(), &status_) == 0;
    if (!there_) where_ = fs::weakly_canonical(fs::absolute(path, ignored), ignored);
  }

  /// Folders and devices are never written, or on purpose; `-` is the standard output.
  [[nodiscard]] bool is_file() const { return !there_ || S_ISREG(status_.st_mode); }

  friend bool operator==(const Place& a, const Place& b) {
    if (a.there_ != b.there_) return false;
    return a.there_ ? a.status_.st_dev == b.status_.st_dev && a.status_.st_ino == b.status_.st_ino
                    : !a.where_.empty() && a.where_ == b.where_;
  }

 private:
  bool there_ = false;
  struct stat status_ = {};
  fs::path where_;
};

void remember(std::vector<Named>& list, const std::string& path, const std::string& name) {
  if (path.empty() || path == "-") return;
  const std::scoped_lock lock(known().mutex);
  const bool is_new = std::ranges::find(list, path, &Named::path) == list.end();
  if (is_new || !name.empty()) list.push_back({path, name.empty() ? path : name});
}

/// A file that was read may have gone since, and another one have its number: it is looked at now.
const Named* at_place(std::span<const Named> list, const Place& place) {
  if (!place.is_file()) return nullptr;
  const auto found =
      std::ranges::find_if(list, [&](const Named& each) { return Place(each.path) == place; });
  return found == list.end() ? nullptr : &*found;
}

}  // namespace

void remember_input(const std::string& path, const std::string& name) {
  remember(known().inputs, path, name);
}

void remember_output(const std::string& path, const std::string& name) {
  remember(known().outputs, path, name);
}

std::optional<OneFile> find_one_file(const std::vector<std::string>& written) {
  const std::scoped_lock lock(known().mutex);
  const std::span<const Named> outputs = known().outputs;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const Place place(outputs[i].path);
    const Named* other = at_place(known().inputs, place);
    if (other == nullptr) other = at_place(outputs.first(i), place);
    if (other != nullptr) return OneFile{outputs[i].name, other->name};
  }
  for (const std::string& path : written) {
    const Place place(path);
    for (const Named& output : outputs) {
      if (Place(output.path) == place) return OneFile{output.name, path};
    }
  }
  return std::nullopt;
}

std::optional<std::string> input_at(const std::string& path) {
  const std::scoped_lock lock(known().mutex);
  const Named* input = at_place(known().inputs, Place(path));
  return input == nullptr ? std::nullopt : std::optional(input->name);
}

void forget_files() {
  const std::scoped_lock lock(known().mutex);
  known().inputs.clear();
  known().outputs.clear();
}

}  // namespace eagerx::gen
