// runtime/host/base/interrupt.hpp: which signals end a run, how often, and what comes first.
#include "runtime/host/base/interrupt.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

namespace eagerx::host {
namespace {

// A closed terminal: from the shell first, from the kernel when the shell has ended. In between,
// the run has to bring its actuators to rest.
TEST(CatchInterrupts, OneThatComesTwiceLeavesTimeToStop) {
  for (const int signal : {SIGHUP, SIGTERM}) {
    EXPECT_EXIT(
        {
          catch_interrupts();
          for (int i = 0; i < 2; ++i) std::raise(signal);
          std::exit(interrupted() ? 0 : 1);
        },
        ::testing::ExitedWithCode(0), "^$");
  }
}

constexpr const char* kSafe = "made safe\n";
void make_safe(void* file) {
  static_cast<void>(!write(file == nullptr ? STDERR_FILENO : *static_cast<int*>(file), kSafe, 10));
}
void catch_all() {
  signal(SIGABRT, SIG_DFL);  // what a test's frame may have caught
  catch_interrupts();
  on_stop(make_safe, nullptr);
}

TEST(CatchInterrupts, NothingThatWouldEndTheProgramDoes) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGUSR1, SIGUSR2, SIGALRM, SIGVTALRM,
                           SIGPROF, SIGXCPU, SIGPOLL, SIGPWR, SIGSTKFLT, SIGRTMIN, SIGRTMAX}) {
    EXPECT_EXIT(
        {
          catch_all();
          std::raise(signal);
          std::exit(interrupted() ? 0 : 1);
        },
        ::testing::ExitedWithCode(0), "^$")
        << signal;
  }
  for (const int signal : {SIGPIPE, SIGXFSZ}) {  // write errors
    EXPECT_EXIT(
        {
          catch_all();
          std::raise(signal);
          std::exit(interrupted() ? 1 : 0);
        },
        ::testing::ExitedWithCode(0), "^$")
        << signal;
  }
}

// A safe action takes longer than two presses of a hand in a hurry.
TEST(CatchInterrupts, ASecondCtrlCAtOnceLeavesTimeToStop) {
  EXPECT_EXIT(
      {
        catch_all();
        std::raise(SIGINT);
        std::raise(SIGINT);
        std::exit(interrupted() ? 0 : 1);
      },
      ::testing::ExitedWithCode(0), "^$");
}

TEST(CatchInterrupts, ALaterCtrlCMakesSafeAndEndsTheProgram) {
  EXPECT_EXIT(
      {
        catch_all();
        std::raise(SIGINT);
        std::this_thread::sleep_for(std::chrono::milliseconds(1100));
        std::raise(SIGINT);
      },
      ::testing::KilledBySignal(SIGINT), kSafe);
}

int overflow(int n) {
  volatile char block[4096];
  block[0] = static_cast<char>(n);
  return n < 0 ? 0 : overflow(n + 1) + block[0];  // the stack ends long before the numbers
}

TEST(CatchInterrupts, ACrashMakesSafeFirst) {
  EXPECT_EXIT((catch_all(), std::abort()), ::testing::KilledBySignal(SIGABRT), kSafe);
#if !defined(__SANITIZE_ADDRESS__)
  EXPECT_EXIT((catch_all(), static_cast<void>(*static_cast<volatile int*>(nullptr))),
              ::testing::KilledBySignal(SIGSEGV), kSafe);
  EXPECT_EXIT((catch_all(), overflow(0)), ::testing::KilledBySignal(SIGSEGV), kSafe);
#endif
}

// The interrupted code may hold a lock that the safe action needs.
TEST(CatchInterrupts, ACrashThatCannotMakeSafeEndsAllTheSame) {
  EXPECT_EXIT(
      {
        catch_all();
        on_stop(
            [](void* /*context*/) {
              for (;;) pause();
            },
            nullptr);
        std::abort();
      },
      ::testing::KilledBySignal(SIGALRM), "");
}

TEST(CatchInterrupts, ACrashThatSomebodySendsEndsInGoodOrder) {
  EXPECT_EXIT(
      {
        catch_all();
        const pid_t parent = getpid();
        const pid_t child = fork();
        if (child == 0) _exit(kill(parent, SIGSEGV));
        waitpid(child, nullptr, 0);
        if (interrupted()) static_cast<void>(!write(STDERR_FILENO, "in order\n", 9));
        end_by_signal();
      },
      ::testing::KilledBySignal(SIGSEGV), "^in order\n$");
}

// Ctrl-Z: safe before it stands still, and not before somebody can command actuators.
TEST(CatchInterrupts, AStopMakesSafeFirst) {
  for (const int signal : {SIGTSTP, SIGTTIN, SIGTTOU}) {
    int pipe[2];
    ASSERT_EQ(::pipe(pipe), 0);
    const pid_t child = fork();
    if (child == 0) {
      setpgid(0, 0);  // a group that somebody outside can continue
      catch_interrupts();
      on_stop(make_safe, &pipe[1]);
      std::raise(signal);
      if (!is_stop_requested()) _exit(1);
      stop_if_requested();
      _exit(is_stop_requested() || interrupted() ? 2 : 0);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, WUNTRACED), child);
    EXPECT_TRUE(WIFSTOPPED(status)) << signal;
    char text[11] = {};
    close(pipe[1]);
    EXPECT_EQ(read(pipe[0], text, 10), 10);
    EXPECT_STREQ(text, kSafe);
    close(pipe[0]);
    kill(child, SIGCONT);
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << signal;
  }
}

TEST(CatchInterrupts, NohupStays) {
  std::signal(SIGHUP, SIG_IGN);
  catch_interrupts();
  EXPECT_EQ(std::signal(SIGHUP, SIG_DFL), SIG_IGN);
}

}  // namespace
}  // namespace eagerx::host
