#include "generator/support/process/companions.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

constexpr int kNoProgram = 127;
constexpr milliseconds kLook(10);
constexpr int kLooksToStart = 6000;  // a minute: an emulator on a busy machine
constexpr int kLooksToEnd = 200;     // before it is killed

/// A file next to its ready file says that companion `which` has ended.
std::string mark_of(const std::string& folder, std::size_t which) {
  return folder + "/ended." + std::to_string(which);
}

[[noreturn]] void exec_companion(const Companion& companion) {
  std::vector<char*> words;
  words.reserve(companion.command.size() + 1);
  for (const std::string& word : companion.command)
    words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  constexpr mode_t kMode = 0644;
  const int log = open(companion.log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, kMode);
  const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
  if (log >= 0 && nothing >= 0 && dup2(nothing, STDIN_FILENO) >= 0 &&
      dup2(log, STDOUT_FILENO) >= 0 && dup2(log, STDERR_FILENO) >= 0)
    execvp(words.front(), words.data());
  _exit(kNoProgram);
}

/// The process that has the companions as its children, and ends them.
class Supervisor {
 public:
  Supervisor(const std::vector<Companion>& companions, const std::string& folder, pid_t parent)
      : companions_(companions), folder_(folder), parent_(parent) {}

  [[noreturn]] void run() {
    setpgid(0, 0);
    sigset_t awaited;
    sigemptyset(&awaited);
    for (const int signal : {SIGCHLD, SIGTERM, SIGINT, SIGHUP}) sigaddset(&awaited, signal);
    sigprocmask(SIG_BLOCK, &awaited, nullptr);
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    leave_terminal();
    for (const Companion& companion : companions_) {
      children_.push_back(fork());
      if (children_.back() == 0) exec_companion(companion);
    }
    // It may have ended before it could be asked for a signal.
    while (getppid() == parent_) {
      int signal = 0;
      if (sigwait(&awaited, &signal) != 0 || signal != SIGCHLD) break;
      note_ended();
    }
    end_all();
    _exit(0);
  }

 private:
  /// Who reads this process's output must not wait for its companions.
  static void leave_terminal() {
    const int nothing = open("/dev/null", O_RDWR);
    for (const int file : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nothing, file);
  }

  bool note_ended() {
    bool lives = false;
    for (std::size_t i = 0; i < children_.size(); ++i) {
      if (children_[i] <= 0) continue;
      if (waitpid(children_[i], nullptr, WNOHANG) == 0) {
        lives = true;
        continue;
      }
      children_[i] = 0;
      close(open(mark_of(folder_, i).c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, S_IRUSR));
    }
    return lives;
  }
  /// With what they have started, which is in their group; and at last this process.
  void end_all() {
    kill(0, SIGTERM);  // which this process does not take
    for (int i = 0; i < kLooksToEnd && note_ended(); ++i) std::this_thread::sleep_for(kLook);
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
    kill(0, SIGKILL);
  }

  const std::vector<Companion>& companions_;
  const std::string& folder_;
  const pid_t parent_;
  std::vector<pid_t> children_;
};

}  // namespace

std::optional<CompanionProblem> start_companions(const std::vector<Companion>& companions,
                                                 const std::string& folder) {
  const pid_t parent = getpid();
  const pid_t supervisor = fork();
  if (supervisor == 0) Supervisor(companions, folder, parent).run();
  std::size_t which = 0;
  bool has_ended = supervisor < 0;
  for (int look = 0; supervisor > 0 && look < kLooksToStart; ++look) {
    std::error_code ignored;
    while (which < companions.size() && fs::exists(companions[which].ready, ignored)) ++which;
    if (which == companions.size()) return std::nullopt;
    has_ended = fs::exists(mark_of(folder, which), ignored);
    if (has_ended) break;
    std::this_thread::sleep_for(kLook);
  }
  if (supervisor > 0) {
    kill(supervisor, SIGTERM);
    while (waitpid(supervisor, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  return CompanionProblem{which, has_ended};
}

}  // namespace eagerx::gen
