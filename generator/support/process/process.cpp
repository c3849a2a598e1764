#include "generator/support/process/process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <utility>

namespace eagerx::gen {
namespace {

constexpr int kNotStarted = 127;

[[noreturn]] void exec(const std::vector<std::string>& command, const ProcessOptions& options,
                       int output) {
  std::vector<char*> arguments;
  arguments.reserve(command.size() + 1);
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  bool good = setpgid(0, 0) == 0 && setenv("LC_ALL", "C", 1) == 0;
  for (const auto& [name, value] : options.environment)
    good = good && setenv(name.c_str(), value.c_str(), 1) == 0;
  const int nothing = open("/dev/null", O_RDWR);
  const int input = options.input >= 0 ? options.input : nothing;
  const int error = options.line ? nothing : output;
  if (good && nothing >= 0 && dup2(input, STDIN_FILENO) >= 0 && dup2(output, STDOUT_FILENO) >= 0 &&
      dup2(error, STDERR_FILENO) >= 0)
    execvp(arguments.front(), arguments.data());
  _exit(kNotStarted);
}

/// The process group that is to end with eagerx-gen; 0: none.
std::atomic<pid_t> running = 0;
std::atomic<int> ended_by = 0;

void pass_on(int signal) {
  ended_by = signal;
  if (const pid_t group = running; group > 0) kill(-group, signal);
}

constexpr std::array kEndingSignals = {SIGINT, SIGTERM, SIGHUP};

/// While it lives, signals go to what runs; then they do what they are for.
class PassSignals {
 public:
  explicit PassSignals(pid_t group) {
    running = group;
    struct sigaction action {};
    action.sa_handler = pass_on;
    sigemptyset(&action.sa_mask);
    for (std::size_t i = 0; i < kEndingSignals.size(); ++i) {
      sigaction(kEndingSignals[i], nullptr, &before_[i]);
      // Signals that are ignored, as under nohup, stay ignored.
      if (before_[i].sa_handler != SIG_IGN) sigaction(kEndingSignals[i], &action, nullptr);
    }
  }
  ~PassSignals() {
    running = 0;
    for (std::size_t i = 0; i < kEndingSignals.size(); ++i)
      sigaction(kEndingSignals[i], &before_[i], nullptr);
    if (const int signal = ended_by.exchange(0); signal != 0) raise(signal);
  }
  PassSignals(const PassSignals&) = delete;
  PassSignals& operator=(const PassSignals&) = delete;

 private:
  std::array<struct sigaction, kEndingSignals.size()> before_{};
};

/// Takes the whole lines from the beginning of `text`, or at its end what is left, too.
void take_lines(std::string& text, bool ended, const ProcessOptions& options) {
  std::string_view rest = text;
  for (std::size_t end = rest.find('\n'); end != std::string_view::npos; end = rest.find('\n')) {
    options.line(rest.substr(0, end));
    rest.remove_prefix(end + 1);
  }
  if (ended && !rest.empty()) options.line(std::exchange(rest, {}));
  text.erase(0, text.size() - rest.size());
}

/// The bytes from `end`, until its last writer closes it; none if it goes to `line`.
std::string read_all(int end, const ProcessOptions& options) {
  constexpr int kWaitMs = 200;
  std::string output;
  std::array<char, 1U << 16U> buffer{};
  for (;;) {
    pollfd what{end, POLLIN, 0};
    const int ready = options.waiting ? poll(&what, 1, kWaitMs) : 1;
    if (options.waiting) options.waiting(output);
    if (ready == 0 || (ready < 0 && errno == EINTR)) continue;
    const ssize_t count = read(end, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count > 0) output.append(buffer.data(), static_cast<std::size_t>(count));
    if (options.line) take_lines(output, count <= 0, options);
    if (count <= 0) return output;
  }
}

}  // namespace

std::optional<ProcessResult> run_process(const std::vector<std::string>& command,
                                         const ProcessOptions& options) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) return std::nullopt;
  const pid_t child = fork();
  if (child == 0) exec(command, options, ends[1]);
  close(ends[1]);
  if (child < 0) {
    close(ends[0]);
    return std::nullopt;
  }
  setpgid(child, child);  // as the child does itself: the order does not matter
  const PassSignals signals(child);
  ProcessResult result;
  result.output = read_all(ends[0], options);
  close(ends[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == kNotStarted && result.output.empty())
    return std::nullopt;
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return result;
}

std::string find_program(const std::string& name) {
  const auto is_program = [](const std::string& path) {
    std::error_code error;
    return std::filesystem::is_regular_file(path, error) && access(path.c_str(), X_OK) == 0;
  };
  if (name.find('/') != std::string::npos) return is_program(name) ? name : "";
  const char* variable = std::getenv("PATH");
  std::string_view folders = variable != nullptr ? variable : "";
  while (!name.empty() && !folders.empty()) {
    const std::size_t end = std::min(folders.find(':'), folders.size());
    std::string path = std::string(folders.substr(0, end)) + "/" + name;
    if (end > 0 && is_program(path)) return path;
    folders.remove_prefix(std::min(end + 1, folders.size()));
  }
  return {};
}

}  // namespace eagerx::gen
