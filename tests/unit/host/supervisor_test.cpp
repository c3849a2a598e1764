// runtime/host/base/supervisor.hpp: a program that is killed, stopped or hangs is made safe by
// another process.
#include "runtime/host/base/supervisor.hpp"

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <string>

namespace eagerx::host {
namespace {

constexpr std::int64_t kNsPerMs = 1'000'000;
constexpr std::int64_t kSilent = 100 * kNsPerMs;

/// A program with a supervisor, and what both write into one pipe.
class Kept : public ::testing::Test {
 protected:
  void SetUp() override { ASSERT_EQ(pipe(ends.data()), 0); }
  void TearDown() override {
    kill(program, SIGKILL);
    for (const int end : ends) close(end);
  }
  /// `life` is what the program does.
  template <class Life>
  void start(Life&& life, std::int64_t most_silent_ns = kSilent) {
    program = fork();
    if (program != 0) return;
    dup2(ends[1], STDERR_FILENO);
    {
      const Supervisor supervisor(
          [](void* end) { return write(*static_cast<int*>(end), "s", 1) == 1; }, &ends[1],
          most_silent_ns);
      life();
    }
    static_cast<void>(!write(ends[1], "e", 1));
    _exit(0);
  }
  /// Text that comes within `ms`, which is long enough for any that must come.
  std::string heard(int ms) {
    std::string text;
    std::array<char, 1024> bytes{};
    for (pollfd item{ends[0], POLLIN, 0}; poll(&item, 1, text.empty() ? ms : 500) > 0;)
      text.append(bytes.data(),
                  static_cast<std::size_t>(read(ends[0], bytes.data(), bytes.size())));
    return text;
  }
  /// The signal that ended the program, 0 if none.
  int end_of_program() const {
    int status = 0;
    waitpid(program, &status, 0);
    return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  }
  static constexpr int kLongMs = 20'000;
  std::array<int, 2> ends{};
  pid_t program = -1;
};

TEST_F(Kept, OneThatEndsWellIsLeftAlone) {
  start([] { send_heartbeat(1, 1); });
  EXPECT_EQ(heard(kLongMs), "e");
  EXPECT_EQ(end_of_program(), 0);
}

TEST_F(Kept, OneThatIsKilledIsMadeSafe) {
  start([] {
    send_heartbeat(1, 1);
    raise(SIGKILL);
  });
  EXPECT_EQ(heard(kLongMs), "s");
}

TEST_F(Kept, OneThatIsStoppedIsEndedAndMadeSafe) {
  start([] {
    send_heartbeat(2, 34);
    raise(SIGSTOP);
  });
  const std::string text = heard(kLongMs);
  EXPECT_TRUE(text.starts_with("serror: the program sent no heartbeat for 0.1 s")) << text;
  EXPECT_NE(text.find("its hardware has the safe values now"), std::string::npos) << text;
  EXPECT_NE(text.find("after step 34, in episode 2"), std::string::npos) << text;
  EXPECT_NE(text.find("help: `heartbeat_timeout:`"), std::string::npos) << text;
  EXPECT_EQ(end_of_program(), SIGKILL) << "it does not drive when it is continued";
}

TEST_F(Kept, OneThatHangsIsEndedAndMadeSafe) {
  start([] {
    send_heartbeat(1, 1);
    const volatile bool hangs = true;
    while (hangs) {
    }
  });
  EXPECT_TRUE(heard(kLongMs).starts_with("serror: "));
  EXPECT_EQ(end_of_program(), SIGKILL);
}

TEST_F(Kept, OneThatSleepsRestsOrHasNotBegunIsAlive) {
  start([] {
    send_heartbeat();  // nothing is driven before the first step
    usleep(300'000);
    send_heartbeat(1, 1);
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    say_asleep_until(std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec + 400 * kNsPerMs);
    usleep(350'000);
    send_heartbeat();
    const WatchdogPause safely;
    const WatchdogPause twice;
    usleep(300'000);
  });
  EXPECT_EQ(heard(kLongMs), "e");
  EXPECT_EQ(end_of_program(), 0);
}

TEST_F(Kept, ZeroMeansForEver) {
  start(
      [] {
        send_heartbeat(1, 1);
        usleep(300'000);
      },
      0);
  EXPECT_EQ(heard(kLongMs), "e");
}

}  // namespace
}  // namespace eagerx::host
