#include "generator/driver/build/build_tree.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <thread>

#include "generator/driver/build/digests.hpp"
#include "generator/driver/build/packages.hpp"
#include "generator/driver/build/progress.hpp"
#include "generator/driver/build/write.hpp"
#include "generator/driver/pipeline/paths.hpp"
#include "generator/support/files/paths.hpp"
#include "generator/support/process/process.hpp"
#include "generator/support/quote/quote.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

std::string toolchain_of(const Run& run, const GenerateOptions& options, const Target& target,
                         const std::string& folder) {
  if (is_standalone(options)) return folder + "/eagerx-gen/toolchains/" + target.toolchain;
  for (const auto& path : options.paths) {
    std::error_code error;
    const fs::path own = fs::path(path) / "toolchains" / target.toolchain;
    if (fs::exists(own, error)) return own.string();
  }
  return (fs::path(run.root) / "toolchains" / target.toolchain).string();
}

/// Environments are vectorized for these instructions besides plain ones. The name is part of the
/// command that configures a tree, so another machine compiles its own. Empty where there are only
/// plain ones.
std::string widest_instruction_set() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))
    return "avx512";
  return __builtin_cpu_supports("avx2") ? "avx2" : "plain";
#else
  return {};
#endif
}

}  // namespace

std::string folder_of(const Run& run, const Target& target) {
  return fs::path(run.sources.name(target.id.span.file)).parent_path().string();
}

bool is_own(const Run& run, const Target& target) {
  return fs::path(folder_of(run, target)).parent_path() != fs::path(run.root) / "targets";
}

Tree tree_of(const Run& run, const GenerateOptions& options, const Target& target,
             const std::string& folder, bool several) {
  Tree tree{folder, folder + (several ? "/build-" + target.id.value : "/build"), {}, {}};
  if (several) tree.settings.emplace_back("EAGERX_TARGET", target.id.value);
  if (options.for_this_machine && !widest_instruction_set().empty())
    tree.settings.emplace_back("EAGERX_INSTRUCTION_SETS", widest_instruction_set());
  if (options.sanitize && target.id.value == "linux-sim") {
    tree.build += "-sanitized";
    tree.settings.emplace_back("EAGERX_SANITIZED", "ON");
  }
  if (!target.toolchain.empty()) tree.toolchain = toolchain_of(run, options, target, folder);
  if (is_own(run, target) && !is_standalone(options)) {
    const fs::path own = absolute_path(folder_of(run, target)).lexically_normal();
    tree.settings.emplace_back("EAGERX_TARGETS_PATH", own.parent_path().string());
  }
  return tree;
}

namespace {

/// The command that configured a build folder; there only if it succeeded.
constexpr const char* kConfigured = "eagerx-gen.configured";
/// Output of CMake and the compiler, of the last build.
constexpr const char* kLog = "eagerx-gen.log";
/// A folder, as only generator/driver/build/write may open files for writing.
constexpr const char* kLock = "eagerx-gen.lock";

bool is_set(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Where libraries that are the same for every graph are kept
/// (runtime/host/compiled_library.cmake); empty where no folder can be made.
std::string library_cache() {
  fs::path folder;
  if (is_set("XDG_CACHE_HOME")) {
    folder = std::getenv("XDG_CACHE_HOME");
  } else if (is_set("HOME")) {
    folder = fs::path(std::getenv("HOME")) / ".cache";
  } else {
    return {};
  }
  folder = folder / "eagerx-gen" / "libraries";
  std::error_code error;
  fs::create_directories(folder, error);
  return access(folder.c_str(), W_OK) == 0 ? absolute_path(folder).lexically_normal().string()
                                           : std::string();
}

void missing(const std::string& program, const std::string& packages, Diagnostics& diagnostics) {
  diagnostics.error("E0513", {}, fmt::format("there is no `{}`", program)).help =
      fmt::format("install it with `apt install {}`", packages);
}

/// "there is no PROGRAM: install it with `apt install PACKAGES`", as toolchain files say, in
/// messages that CMake has wrapped. True if it is found and reported.
bool tell_missing(const std::string& output, Diagnostics& diagnostics) {
  std::string text;
  for (const char c : output) {
    const bool blank = std::isspace(static_cast<unsigned char>(c)) != 0;
    if (!blank) text += c;
    if (blank && !text.empty() && text.back() != ' ') text += ' ';
  }
  constexpr std::string_view kBegin = "there is no ", kMiddle = ": install it with `apt install ";
  const std::size_t middle = text.find(kMiddle);
  if (middle == std::string::npos) return false;
  const std::size_t begin = text.rfind(kBegin, middle);
  const std::size_t end = text.find('`', middle + kMiddle.size());
  if (begin == std::string::npos || end == std::string::npos) return false;
  missing(text.substr(begin + kBegin.size(), middle - begin - kBegin.size()),
          text.substr(middle + kMiddle.size(), end - middle - kMiddle.size()), diagnostics);
  return true;
}

/// From the first line that begins with one of these, at most as many lines as anybody reads.
std::string excerpt(const std::string& output) {
  constexpr std::size_t kMostLines = 60;
  std::size_t begin = std::string::npos;
  for (const std::string_view mark : {"FAILED: ", "CMake Error", "make: ", "ninja: error"}) {
    const std::size_t at = output.starts_with(mark) ? 0 : output.find("\n" + std::string(mark));
    begin = std::min(begin, at);
  }
  std::string text = begin == std::string::npos ? output : output.substr(begin);
  text.erase(0, std::min(text.find_first_not_of('\n'), text.size()));
  std::size_t end = 0;
  for (std::size_t line = 0; line < kMostLines && end != std::string::npos; ++line)
    end = text.find('\n', end + (line > 0 ? 1 : 0));
  if (end != std::string::npos) text.resize(end);
  while (text.ends_with('\n')) text.pop_back();
  return text;
}

/// "3 of 40 files" of Ninja's last "[3/40] …", "12 %" of make's last "[ 12%] …", or nothing.
std::string how_far(const std::string& output) {
  for (std::size_t at = output.rfind('['); at != std::string::npos && at > 0;
       at = output.rfind('[', at - 1)) {
    const std::size_t end = output.find(']', at);
    const bool line_begins = output[at - 1] == '\n';
    if (!line_begins || end == std::string::npos) continue;
    const std::string inside = output.substr(at + 1, end - at - 1);
    const std::size_t slash = inside.find('/');
    if (inside.find_first_not_of("0123456789/% ") != std::string::npos) continue;
    if (slash != std::string::npos)
      return fmt::format("{} of {} files", inside.substr(0, slash), inside.substr(slash + 1));
    const std::size_t digit = inside.find_first_not_of(' ');
    if (inside.ends_with('%') && digit != std::string::npos)
      return fmt::format("{} %", inside.substr(digit, inside.size() - 1 - digit));
  }
  return {};
}

/// Whether there is a ccache that can write into its folder; else it fails, and the build with it.
bool has_compiler_cache() {
  if (find_program("ccache").empty()) return false;
  const auto answer = run_process({"ccache", "--get-config", "cache_dir"}, {});
  if (!answer || answer->exit_code != 0) return false;
  std::error_code error;
  fs::path folder = answer->output.substr(0, answer->output.find('\n'));
  // A folder that does not exist is created in the nearest one that does.
  while (folder.has_relative_path() && !fs::exists(folder, error)) folder = folder.parent_path();
  return fs::is_directory(folder, error) && access(folder.c_str(), W_OK | X_OK) == 0;
}
/// While it lives, no other build works in the folder. What a build starts inherits the lock: one
/// that was killed leaves compilers behind, and the next one must wait for them, since they write
/// the same files. Not for ever: also a server that somebody's compiler starts inherits it.
class BuildLock {
 public:
  explicit BuildLock(const fs::path& folder) {
    using namespace std::chrono_literals;
    std::error_code ignored;
    fs::create_directories(folder / kLock, ignored);
    lock_ = open((folder / kLock).c_str(), O_RDONLY | O_DIRECTORY);
    const auto end = std::chrono::steady_clock::now() + 60s;
    while (lock_ >= 0 && flock(lock_, LOCK_EX | LOCK_NB) != 0 &&
           (errno == EWOULDBLOCK || errno == EINTR) && std::chrono::steady_clock::now() < end)
      std::this_thread::sleep_for(10ms);
  }
  ~BuildLock() {
    if (lock_ < 0) return;
    futimens(lock_, nullptr);  // when the last build was
    close(lock_);
  }
  BuildLock(const BuildLock&) = delete;
  BuildLock& operator=(const BuildLock&) = delete;

  /// When the last build was; 1970 if that is not known.
  [[nodiscard]] timespec last_build() const {
    struct stat found {};
    return lock_ >= 0 && fstat(lock_, &found) == 0 ? found.st_mtim : timespec{};
  }
  /// Whether the clock has been set back since the last build.
  [[nodiscard]] bool last_build_is_to_come() const {
    timespec now{};
    clock_gettime(CLOCK_REALTIME, &now);
    constexpr time_t kPrecisionS = 2;  // of some file systems
    return last_build().tv_sec > now.tv_sec + kPrecisionS;
  }

 private:
  int lock_ = -1;
};

class Builder {
 public:
  Builder(const Tree& tree, std::string name, bool quiet, Diagnostics& diagnostics)
      : tree_(tree), name_(std::move(name)), quiet_(quiet), diagnostics_(diagnostics) {}

  bool run(const std::string& cmake_target) {
    if (!has_programs()) return false;
    const BuildLock lock(tree_.build);
    if (!configure()) return false;
    const Digests digests(tree_.build);
    std::vector<std::string> command = {"cmake", "--build", tree_.build, "--parallel",
                                        std::to_string(std::thread::hardware_concurrency())};
    // A file changed since then may have an older time stamp than the output of its previous
    // version.
    if (lock.last_build_is_to_come() || digests.have_unseen_change(lock.last_build()))
      command.emplace_back("--clean-first");
    if (!cmake_target.empty()) command.insert(command.end(), {"--target", cmake_target});
    if (!step("building", command)) return false;
    keep(digests);
    return true;
  }

 private:
  /// Records the compiled files. Ninja lists them; for Make each object has a file next to it.
  void keep(const Digests& digests) {
    const bool is_ninja = !text_of(fs::path(tree_.build) / "build.ninja").empty();
    const auto listed = is_ninja ? run_process({"ninja", "-C", tree_.build, "-t", "deps"})
                                 : std::optional<ProcessResult>();
    if (is_ninja && (!listed || listed->exit_code != 0)) return;
    const std::string text =
        digests.now(is_ninja ? listed->output : listed_in_depfiles(tree_.build));
    if (!text.empty()) write_file((fs::path(tree_.build) / kDigests).string(), text, diagnostics_);
  }

  bool has_programs() {
    const auto need = [&](std::initializer_list<const char*> any_of, const char* package) {
      for (const char* each : any_of) {
        if (!find_program(each).empty()) return true;
      }
      missing(*any_of.begin(), package, diagnostics_);
      return false;
    };
    if (!need({"cmake"}, "cmake")) return false;
    if (!is_set("CMAKE_GENERATOR") && !need({"ninja", "make"}, "ninja-build")) return false;
    return !tree_.toolchain.empty() || is_set("CXX") || need({"c++", "g++", "clang++"}, "g++");
  }

  [[nodiscard]] std::vector<std::string> configuring() const {
    std::vector<std::string> words = {"cmake", "--fresh", "-S", tree_.source, "-B", tree_.build};
    if (!is_set("CMAKE_GENERATOR") && !find_program("ninja").empty())
      words.insert(words.end(), {"-G", "Ninja"});
    if (!tree_.toolchain.empty()) words.insert(words.end(), {"--toolchain", tree_.toolchain});
    for (const auto& [name, value] : tree_.settings)
      words.insert(words.end(), {"-D", fmt::format("{}={}", name, value)});
    if (const std::string package = package_folder(); !package.empty())
      words.insert(words.end(), {"-D", "eagerx_gen_DIR=" + package});
    if (const std::string kept = library_cache(); !kept.empty())
      words.insert(words.end(), {"-D", "EAGERX_LIBRARY_CACHE=" + kept});
    if (!is_set("CMAKE_CXX_COMPILER_LAUNCHER") && has_compiler_cache())
      words.insert(words.end(), {"-D", "CMAKE_CXX_COMPILER_LAUNCHER=ccache"});
    return words;
  }

  bool configure() {
    const std::vector<std::string> command = configuring();
    std::string line;
    for (const std::string& word : command) line += shell_word(word) + " ";
    for (const char* variable : {"CXX", "CXXFLAGS", "CMAKE_GENERATOR", "CMAKE_BUILD_TYPE",
                                 "CMAKE_CXX_COMPILER_LAUNCHER"}) {
      if (is_set(variable)) line += fmt::format("{}={} ", variable, std::getenv(variable));
    }
    line += "\n";
    const fs::path stamp = fs::path(tree_.build) / kConfigured;
    if (text_of(stamp) == line) return true;
    std::error_code error;
    fs::create_directories(tree_.build, error);
    fs::remove(stamp, error);
    return step("preparing", command) && write_file(stamp.string(), line, diagnostics_);
  }

  /// Runs a command and tells how far it is.
  bool step(const char* what, const std::vector<std::string>& command) {
    Progress progress(fmt::format("{} {}", what, name_), quiet_);
    ProcessOptions options;
    options.environment = {{"NINJA_STATUS", "[%f/%t] "}, {"CLICOLOR_FORCE", "0"}};
    options.waiting = [&](const std::string& output) { progress.at(how_far(output)); };
    const auto result = run_process(command, options);
    const bool good = result && result->exit_code == 0;
    progress.finish(good);
    if (good) return true;
    if (!result) {
      missing(command.front(), command.front(), diagnostics_);
    } else if (!tell_missing(result->output, diagnostics_)) {
      const std::string log = (fs::path(tree_.build) / kLog).string();
      auto& problem =
          diagnostics_.error("E0514", {}, fmt::format("`{}` does not build", tree_.source));
      problem.notes.push_back({excerpt(result->output), {}, ""});
      problem.help = fmt::format("all that was said is in `{}`", log);
      write_file(log, result->output, diagnostics_);
    }
    return false;
  }

  const Tree& tree_;
  std::string name_;
  bool quiet_;
  Diagnostics& diagnostics_;
};

}  // namespace

bool build_tree(const Tree& tree, const std::string& name, bool quiet, Diagnostics& diagnostics,
                const std::string& cmake_target) {
  return Builder(tree, name, quiet, diagnostics).run(cmake_target);
}

}  // namespace eagerx::gen
