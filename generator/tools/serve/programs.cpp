#include "generator/tools/serve/programs.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <utility>

#include "generator/support/diagnostics/search.hpp"
#include "generator/support/files/paths.hpp"
#include "generator/support/process/background_process.hpp"
#include "generator/tools/serve/status.hpp"

namespace eagerx::gen::serve {
namespace {

namespace fs = std::filesystem;

constexpr int kCannotStart = 127;  // as a shell says it
constexpr std::array kKinds = {"check", "run", "report", "simulate", "train", "linearize"};
constexpr const char* kResult = "result.html";
constexpr std::size_t kMostPageBytes = 256U << 20U;
constexpr const char* kCurve = "curve.csv";
constexpr const char* kLoop = "loop.json";

/// Nothing: they are no words of a command line.
std::optional<std::vector<std::string>> words_of(const Json* json) {
  constexpr std::size_t kMostWords = 100, kLongestWord = 4096;
  std::vector<std::string> words;
  if (json == nullptr) return words;
  const auto* const list = json->as<Json::List>();
  if (list == nullptr || list->size() > kMostWords) return std::nullopt;
  for (const Json& each : *list) {
    const auto* const word = each.as<std::string>();
    if (word == nullptr || word->size() > kLongestWord || word->find('\0') != std::string::npos)
      return std::nullopt;
    words.push_back(*word);
  }
  return words;
}

/// A number, or as text what is none.
Json cell(std::string_view text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_number = error == std::errc() && end == text.data() + text.size();
  if (text.empty()) return nullptr;
  return is_number ? Json(number) : Json(std::string(text));
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(separator), text.size());
    parts.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return parts;
}

/// Nothing: it is not there.
std::optional<fs::file_time_type> written_at(const std::string& path) {
  std::error_code error;
  const auto time = fs::last_write_time(path, error);
  return error ? std::nullopt : std::optional(time);
}

constexpr const char* kFolder = "eagerx-gen-serve-";

/// Folders of servers that were killed: each server locks its own for as long as it lives. What is
/// younger than a minute may be one that is just being made.
void remove_left_folders(const fs::path& place) {
  constexpr time_t kYoungS = 60;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(place, error)) {
    if (!entry.path().filename().string().starts_with(kFolder)) continue;
    const int folder =
        open(entry.path().c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK);
    if (folder < 0) continue;
    struct stat status {};
    const bool is_left = fstat(folder, &status) == 0 && status.st_uid == geteuid() &&
                         time(nullptr) - status.st_mtim.tv_sec > kYoungS &&
                         flock(folder, LOCK_EX | LOCK_NB) == 0;
    std::error_code ignored;
    if (is_left) fs::remove_all(entry.path(), ignored);
    close(folder);
  }
}

}  // namespace

Programs::Programs(std::vector<std::string> self, std::string graph)
    : self_(std::move(self)), graph_(absolute_path(std::move(graph)).string()) {
  std::error_code error;
  const fs::path place = fs::temp_directory_path(error);
  if (error) return;
  remove_left_folders(place);
  std::string name = (place / (std::string(kFolder) + "XXXXXX")).string();
  if (mkdtemp(name.data()) == nullptr) return;
  folder_ = name;
  lock_ = open(name.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (lock_ >= 0) flock(lock_, LOCK_EX | LOCK_NB);
}

Programs::~Programs() {
  end();
  if (thread_.joinable()) thread_.join();
  std::error_code ignored;
  if (!folder_.empty()) fs::remove_all(folder_, ignored);
  if (lock_ >= 0) close(lock_);
}

std::string Programs::place_of(const char* name) const {
  return (fs::path(folder_) / name).string();
}

Reply Programs::start(const Json& request) {
  std::unique_lock lock(mutex_);
  const std::string kind = text_of(member(&request, "kind"));
  if (!ranges::contains(kKinds, kind))
    return failure(kBadRequest, fmt::format("there is no program `{}`", kind),
                   "available: check, run, report, simulate, train, linearize");
  const auto words = words_of(member(&request, "arguments"));
  if (!words) return failure(kBadRequest, "`arguments` is not a list of words");
  if (running_ || ended_)
    return failure(kConflict, fmt::format("`{}` runs already", kind_), "stop it first");
  if (folder_.empty()) return failure(kFailed, "there is no folder for temporary files");
  if (thread_.joinable()) thread_.join();

  const bool makes_page = kind == "report" || kind == "simulate";
  std::vector<std::string> command = {self_.front(), makes_page ? "report" : kind, graph_};
  command.insert(command.end(), self_.begin() + 1, self_.end());
  std::error_code ignored;
  for (const char* const name : {kResult, kCurve, kLoop}) fs::remove(place_of(name), ignored);
  curve_file_.clear();
  if (makes_page) command.insert(command.end(), {"--output", place_of(kResult)});
  if (kind == "linearize") command.insert(command.end(), {"--plot", place_of(kLoop)});
  if (kind == "simulate") command.emplace_back("--simulate");
  if (kind == "train") {
    const auto own = ranges::find(*words, "--csv");
    const bool is_given = own != words->end() && own + 1 != words->end();
    curve_file_ =
        is_given ? (fs::path(graph_).parent_path() / *(own + 1)).string() : place_of(kCurve);
    if (!is_given) command.insert(command.end(), {"--csv", curve_file_});
    old_curve_ = written_at(curve_file_);
  }
  command.insert(command.end(), words->begin(), words->end());
  kind_ = kind;
  running_ = true;
  exit_code_.reset();
  interrupted_.reset();
  lines_.clear();
  first_line_ = 0;
  ++id_;
  thread_ = std::thread([this, command] { run(command); });
  return {200, Json{{"id", id_}}};
}

void Programs::run(const std::vector<std::string>& command) {
  BackgroundOptions options;
  options.folder = fs::path(graph_).parent_path().string();
  options.line = [this](std::string_view line, bool is_error) { add(line, is_error); };
  options.group = [this](pid_t group) {
    const std::lock_guard lock(mutex_);
    group_ = group;
    if (ended_) signal(SIGTERM);
    if (interrupted_) signal(SIGINT);  // Stop came before there was anything to stop
  };
  const auto code = run_in_background(command, options);
  if (!code) add(fmt::format("error: cannot start eagerx-gen: {}", std::strerror(errno)), true);
  const std::lock_guard lock(mutex_);
  exit_code_ = code.value_or(kCannotStart);
  running_ = false;
  changed_.notify_all();
}

void Programs::add(std::string_view line, bool is_error) {
  const std::lock_guard lock(mutex_);
  lines_.push_back({std::string(line.substr(0, kLongestLine)), is_error});
  if (lines_.size() > kMostLines) {
    lines_.pop_front();
    ++first_line_;
  }
  changed_.notify_all();
}

Json Programs::curve(std::uint64_t row) const {
  Json json{{"columns", Json::list()}, {"rows", Json::list()}, {"next", row}};
  if (curve_file_.empty() || written_at(curve_file_) == old_curve_) return json;
  const FileText file = GraphFile(curve_file_).read();
  std::string_view text = file.text;
  text = text.substr(0, text.rfind('\n') + 1);  // whole lines
  const auto lines = split(text, '\n');
  if (lines.empty()) return json;
  for (const std::string_view name : split(lines.front(), ','))
    json["columns"].push_back(std::string(name));
  for (std::uint64_t i = row + 1; i < lines.size(); ++i) {
    Json cells = Json::list();
    for (const std::string_view each : split(lines[i], ',')) cells.push_back(cell(each));
    json["rows"].push_back(std::move(cells));
  }
  json["next"] = std::max<std::uint64_t>(row, lines.size() - 1);
  return json;
}

Reply Programs::output(std::uint64_t after, std::uint64_t row, double seconds) {
  constexpr auto kLookEvery = std::chrono::milliseconds(300);  // at the curve
  std::unique_lock lock(mutex_);
  const auto until = Clock::now() + std::chrono::duration<double>(seconds);
  const std::int64_t id = id_;
  const bool ran = running_;
  Json rows = curve(row);
  const auto is_new = [&] {
    return ended_ || id_ != id || running_ != ran || first_line_ + lines_.size() > after;
  };
  while (!is_new() && running_ && Clock::now() < until) {
    rows = curve(row);
    if (!rows["rows"].as<Json::List>()->empty()) break;
    changed_.wait_for(lock, kLookEvery);
  }
  rows = curve(row);
  Json lines = Json::list();
  for (std::uint64_t n = std::max(after, first_line_); n < first_line_ + lines_.size(); ++n) {
    const Line& line = lines_[n - first_line_];
    lines.push_back(Json{{"n", n}, {"text", line.text}, {"error", line.is_error}});
  }
  std::error_code ignored;
  const bool has_result = !running_ && exit_code_ == 0 && fs::exists(place_of(kResult), ignored);
  return {200, Json{{"id", id_},
                    {"kind", kind_},
                    {"running", running_},
                    {"exit_code", exit_code_ ? Json(*exit_code_) : Json(nullptr)},
                    {"lines", std::move(lines)},
                    {"next", first_line_ + lines_.size()},
                    {"curve", std::move(rows)},
                    {"result", has_result}}};
}

void Programs::signal(int number) {
  if (group_ > 0) kill(-group_, number);
}

Reply Programs::stop() {
  constexpr auto kPatience = std::chrono::seconds(5);
  const std::lock_guard lock(mutex_);
  const auto now = Clock::now();
  const bool again = interrupted_ && now - *interrupted_ >= kPatience;
  if (running_) signal(again ? SIGKILL : SIGINT);
  if (!interrupted_) interrupted_ = now;
  return {};
}

Json Programs::running() {
  const std::lock_guard lock(mutex_);
  return running_ ? Json{{"kind", kind_}, {"id", id_}} : Json(nullptr);
}

std::optional<std::string> Programs::result() {
  return written(kResult);
}
std::optional<std::string> Programs::loop() {
  return written(kLoop);
}

std::optional<std::string> Programs::written(const char* name) {
  const std::lock_guard lock(mutex_);
  if (running_ || folder_.empty()) return std::nullopt;
  const FileText file = GraphFile(place_of(name)).read(kMostPageBytes);
  return file.exists && file.problem.empty() ? std::optional(file.text) : std::nullopt;
}

void Programs::end() {
  constexpr auto kPatience = std::chrono::seconds(5);
  std::unique_lock lock(mutex_);
  ended_ = true;
  changed_.notify_all();
  if (!running_) return;
  signal(SIGTERM);
  if (!changed_.wait_for(lock, kPatience, [&] { return !running_; })) signal(SIGKILL);
}

}  // namespace eagerx::gen::serve
