#include "generator/support/process/background_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>

namespace eagerx::gen {
namespace {

constexpr int kCannotStart = 127;
constexpr int kSignalled = 128;
constexpr std::size_t kLongestLine = 1U << 16U;

/// After fork() of a program with threads: nothing here allocates memory.
[[noreturn]] void start(char* const* arguments, const char* folder, int output, int error,
                        int trouble) {
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  signal(SIGPIPE, SIG_DFL);
  const int nothing = open("/dev/null", O_RDONLY);
  if (setpgid(0, 0) == 0 && prctl(PR_SET_PDEATHSIG, SIGTERM) == 0 && chdir(folder) == 0 &&
      nothing >= 0 && dup2(nothing, STDIN_FILENO) >= 0 && dup2(output, STDOUT_FILENO) >= 0 &&
      dup2(error, STDERR_FILENO) >= 0)
    execv(arguments[0], arguments);
  const int why = errno;
  static_cast<void>(!write(trouble, &why, sizeof why));
  _exit(kCannotStart);
}

struct Pipe {
  std::array<int, 2> ends{-1, -1};
  Pipe() { static_cast<void>(!pipe2(ends.data(), O_CLOEXEC)); }
  ~Pipe() {
    close_end(0);
    close_end(1);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  void close_end(std::size_t end) {
    if (ends[end] >= 0) close(ends[end]);
    ends[end] = -1;
  }
};

/// One of its streams, cut into lines. A carriage return ends one, too: progress is written so.
class Lines {
 public:
  Lines(Pipe& pipe, bool is_error, const BackgroundOptions& options)
      : pipe_(pipe), is_error_(is_error), options_(options) {}

  [[nodiscard]] int descriptor() const { return pipe_.ends[0]; }

  void read_some() {
    std::array<char, 1U << 16U> bytes{};
    const ssize_t count = read(descriptor(), bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) return;
    if (count <= 0) {
      flush();
      pipe_.close_end(0);
      return;
    }
    for (const char c : std::string_view(bytes.data(), static_cast<std::size_t>(count))) {
      if (c == '\n' || c == '\r')
        flush();
      else if (line_.size() < kLongestLine)
        line_ += c;
    }
  }
  void flush() {
    if (!line_.empty()) options_.line(line_, is_error_);
    line_.clear();
  }

 private:
  Pipe& pipe_;
  bool is_error_;
  const BackgroundOptions& options_;
  std::string line_;
};

/// Without taking it away, so that its number stays its own.
bool has_ended(pid_t child) {
  siginfo_t facts{};
  return waitid(P_PID, static_cast<id_t>(child), &facts, WEXITED | WNOHANG | WNOWAIT) == 0 &&
         facts.si_pid == child;
}

/// Until both streams are closed, or the program has ended and others keep them open.
void read_lines(Lines& output, Lines& error, pid_t child) {
  constexpr int kWaitMs = 100;
  while (output.descriptor() >= 0 || error.descriptor() >= 0) {
    std::array<pollfd, 2> waited{
        {{output.descriptor(), POLLIN, 0}, {error.descriptor(), POLLIN, 0}}};
    const bool ended = has_ended(child);
    const int ready = poll(waited.data(), waited.size(), kWaitMs);
    if (ready == 0 && ended) break;
    if (waited[0].revents != 0) output.read_some();
    if (waited[1].revents != 0) error.read_some();
  }
  output.flush();
  error.flush();
}

}  // namespace

std::optional<int> run_in_background(const std::vector<std::string>& command,
                                     const BackgroundOptions& options) {
  std::vector<char*> arguments;
  arguments.reserve(command.size() + 1);
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  Pipe output, error, trouble;
  if (output.ends[0] < 0 || error.ends[0] < 0 || trouble.ends[0] < 0) return std::nullopt;
  const pid_t child = fork();
  if (child == 0)
    start(arguments.data(), options.folder.c_str(), output.ends[1], error.ends[1], trouble.ends[1]);
  if (child < 0) return std::nullopt;
  setpgid(child, child);  // as the child does itself: the order does not matter
  for (Pipe* const pipe : {&output, &error, &trouble}) pipe->close_end(1);
  int why = 0;
  const bool failed = read(trouble.ends[0], &why, sizeof why) == sizeof why;
  if (!failed) {
    options.group(child);
    Lines lines(output, false, options), errors(error, true, options);
    read_lines(lines, errors, child);
    siginfo_t facts{};
    while (waitid(P_PID, static_cast<id_t>(child), &facts, WEXITED | WNOWAIT) < 0 &&
           errno == EINTR) {
    }
    options.group(0);
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  errno = why;
  if (failed) return std::nullopt;
  return WIFEXITED(status) ? WEXITSTATUS(status) : kSignalled + WTERMSIG(status);
}

}  // namespace eagerx::gen
