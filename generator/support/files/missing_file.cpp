#include "generator/support/files/missing_file.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "runtime/host/base/nearest.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

/// Those without whose end `name` without its own is near: a long end makes too much alike.
std::vector<std::string> with_near_stem(const fs::path& name,
                                        const std::vector<std::string>& names) {
  std::vector<std::string> result;
  for (const std::string& each : names) {
    if (!host::nearest_name(name.stem().string(), {fs::path(each).stem().string()}).empty())
      result.push_back(each);
  }
  return result;
}

/// Names of `names` that end as `name` does; none for a name without an end.
std::vector<std::string> of_one_kind(const fs::path& name, const std::vector<std::string>& names) {
  std::vector<std::string> result;
  const std::string end = name.extension().string();
  for (const std::string& each : names)
    if (!end.empty() && fs::path(each).extension() == end) result.push_back(each);
  return result;
}

}  // namespace

std::vector<std::string> entries_of_folder(const std::string& path) {
  constexpr std::size_t kMostEntries = 1000;
  std::vector<std::string> names;
  std::error_code error;
  if (!fs::is_directory(path, error)) return names;
  for (auto entry = fs::directory_iterator(path, error);
       !error && entry != fs::directory_iterator() && names.size() < kMostEntries;
       entry.increment(error)) {
    names.push_back(entry->path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string help_for_deleted_folder(const std::string& path) {
  std::error_code error;
  const bool is_absolute = fs::path(path).is_absolute();
  if (is_absolute || !fs::current_path(error).empty()) return {};
  return "the current folder has been deleted: change to one that exists";
}

Help help_for_missing(const std::string& path, const std::string& written) {
  constexpr std::size_t kFew = 3;
  std::error_code error;
  const fs::path file(path);
  if (path.empty() || fs::exists(file, error)) return {};
  if (std::string help = help_for_deleted_folder(path); !help.empty()) return help;
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  const fs::path mentioned = fs::path(written).parent_path();
  if (!fs::is_directory(folder, error))
    return mentioned.empty() ? "" : "there is no folder `" + mentioned.string() + "`";
  const std::vector<std::string> names = entries_of_folder(folder.string());
  const auto as_written = [&](const std::string& name) { return (mentioned / name).string(); };
  const std::string near =
      host::nearest_name(file.filename().string(), with_near_stem(file, names));
  if (!near.empty()) return meaning(as_written(near));
  const std::vector<std::string> alike = of_one_kind(file, names);
  if (alike.empty() || alike.size() > kFew) return {};
  std::string all;
  for (const std::string& name : alike) all += (all.empty() ? "`" : ", `") + as_written(name) + "`";
  return "available: " + all;
}

}  // namespace eagerx::gen
