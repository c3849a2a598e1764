#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <runtime/host/base/keeper.hpp>

namespace eagerx::host {
namespace {

/// Whether a byte has come, which says that nothing is to be done; else the program has ended.
bool is_dismissed(int line) {
  char byte = 0;
  ssize_t count = 0;
  do count = read(line, &byte, 1);
  while (count < 0 && errno == EINTR);
  return count == 1;
}

/// What the program had open is free once it is no more our parent.
void wait_for_its_end(pid_t program) {
  constexpr int kMostLooks = 2'000;
  constexpr useconds_t kLookUs = 1'000;
  for (int look = 0; look < kMostLooks && getppid() == program; ++look) usleep(kLookUs);
}

[[noreturn]] void keep(int line, pid_t program, void (*take_over)(void*), void* context) {
  setsid();
  // Those that the program ends well after, and tells us.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGUSR1, SIGUSR2, SIGPIPE})
    static_cast<void>(std::signal(signal, SIG_IGN));
  if (!is_dismissed(line)) {
    wait_for_its_end(program);
    take_over(context);
  }
  _exit(0);
}

}  // namespace

Keeper::Keeper(void (*take_over)(void*), void* context) {
  if (take_over == nullptr) return;
  std::array<int, 2> ends{};
  const pid_t program = getpid();
  const bool has_line = pipe2(ends.data(), O_CLOEXEC) == 0;
  if (has_line) process_ = fork();
  if (process_ == 0) {
    close(ends[1]);
    keep(ends[0], program, take_over, context);
  }
  if (process_ < 0) {
    static_cast<void>(std::fprintf(
        stderr, "warning: nobody makes the hardware safe if this program is killed: %s\n",
        std::strerror(errno)));
  }
  if (has_line) close(ends[0]);
  if (has_line && process_ < 0) close(ends[1]);
  if (process_ > 0) line_ = ends[1];
}

Keeper::~Keeper() {
  if (process_ <= 0) return;
  const char byte = 1;
  ssize_t written = 0;
  do written = write(line_, &byte, 1);
  while (written < 0 && errno == EINTR);
  close(line_);
  while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

}  // namespace eagerx::host
