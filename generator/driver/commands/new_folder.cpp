#include "generator/driver/commands/new_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "generator/backend/emit/render.hpp"
#include "generator/driver/build/write.hpp"
#include "generator/driver/pipeline/paths.hpp"
#include "generator/support/diagnostics/search.hpp"
#include "generator/support/process/process.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kBlank = ".blank";

/// A command that starts this program from where the user is: its name, if the shell finds it.
std::string program_command() {
  std::error_code error;
  const std::string self = fs::read_symlink("/proc/self/exe", error).string();
  const std::string found = find_program("eagerx-gen");
  const bool same = !found.empty() && fs::equivalent(found, self, error);
  return same ? "eagerx-gen" : self;
}

/// Where CMake looks for packages by itself.
bool is_usual(const std::string& package) {
  return ranges::any_of(std::array{"/usr/share/", "/usr/local/share/"},
                        [&](const char* each) { return package.starts_with(each); });
}

}  // namespace

std::string class_name_of(std::string_view name) {
  std::string type;
  bool begins = true;
  for (const char c : name) {
    if (c == '_' || c == '-') {
      begins = true;
      continue;
    }
    type += begins ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    begins = false;
  }
  return type;
}

std::string word_of(std::string_view name, char between) {
  std::string word;
  for (const char c : name) {
    const auto letter = static_cast<unsigned char>(c);
    if (letter >= 0x80 || std::isalnum(letter) == 0) {
      if (!word.empty() && word.back() != between) word += between;
      continue;
    }
    if (std::isupper(letter) != 0 && !word.empty() && word.back() != between) word += between;
    word += static_cast<char>(std::tolower(letter));
  }
  while (!word.empty() && (word.back() == between)) word.pop_back();
  return word;
}

View view_of_new(const std::string& name, const fs::path& folder) {
  View view = object();
  view.set("name", name);
  view.set("name_word", word_of(name, '_'));
  view.set("type", class_name_of(name));
  view.set("version", EAGERX_GEN_VERSION);
  view.set("folder", folder.string());
  view.set("parent", folder.has_parent_path() ? folder.parent_path().string() : ".");
  view.set("program", program_command());
  const std::string package = package_folder();
  view.set("package", text_or_false(is_usual(package) ? "" : package));
  return view;
}

std::vector<NewFile> rendered_files(const std::string& templates, const std::string& name,
                                    const View& view, Diagnostics& diagnostics) {
  std::vector<NewFile> files;
  std::error_code error;
  for (const auto& entry : fs::recursive_directory_iterator(templates, error)) {
    std::string path = entry.path().lexically_relative(templates).string();
    if (!entry.is_regular_file(error) || !path.ends_with(kBlank)) continue;
    path.resize(path.size() - kBlank.size());
    constexpr std::string_view kName = "@name@";
    for (std::size_t at = path.find(kName); at != std::string::npos; at = path.find(kName))
      path.replace(at, kName.size(), name);
    auto text = render_file(entry.path().string(), path, view, diagnostics);
    if (!text) return {};
    const bool is_program =
        (entry.status(error).permissions() & fs::perms::owner_exec) != fs::perms::none;
    files.push_back({std::move(path), std::move(*text), is_program});
  }
  std::ranges::sort(files, {}, &NewFile::path);
  return files;
}

bool is_free_place(const fs::path& folder, Diagnostics& diagnostics) {
  std::error_code error;
  if (!fs::exists(fs::symlink_status(folder, error))) return true;
  diagnostics
      .io_error("E0902", {}, fmt::format("there is already something at `{}`", folder.string()))
      .help = "choose another name, or another folder with --output";
  return false;
}

void write_new_folder(const fs::path& folder, const std::vector<NewFile>& files,
                      Diagnostics& diagnostics) {
  std::error_code error;
  // Under a temporary name first: a folder without some of its files would look complete.
  const fs::path begun =
      folder.parent_path() / fmt::format(".{}.eagerx-gen.new", folder.filename().string());
  fs::remove_all(begun, error);  // of a run that was killed
  bool good = true;
  for (const NewFile& file : files) {
    const fs::path path = begun / file.path;
    if (file.path == kNextSteps) continue;
    fs::create_directories(path.parent_path(), error);
    good = good && write_file(path.string(), file.text, diagnostics);
    if (good && file.is_program)
      fs::permissions(path, fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec,
                      fs::perm_options::add, error);
  }
  if (good) fs::rename(begun, folder, error);
  if (good && error)
    diagnostics.io_error("E0901", {},
                         fmt::format("cannot make `{}`: {}", folder.string(), error.message()));
  fs::remove_all(begun, error);
}

}  // namespace eagerx::gen
