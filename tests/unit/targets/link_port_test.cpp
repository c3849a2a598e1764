// targets/linux-sim/link_port.hpp: foreign sockets and serial lines are left alone.
#include "targets/linux-sim/link_port.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <eagerx/link/host.hpp>
#include <string>
#include <thread>

namespace eagerx::linux_sim {
namespace {

std::string said;            // by the thread that listens
std::atomic<int> times = 0;  // that something was said
void say(const std::string& text) {
  said = text;
  ++times;
}
void wait_until_said(int count) {
  for (int i = 0; i < 1000 && times < count; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  ASSERT_GE(times, count);
}

class Sockets : public ::testing::Test {
 protected:
  void SetUp() override {
    char name[] = "/tmp/eagerx_port_XXXXXX";
    ASSERT_NE(mkdtemp(name), nullptr);
    folder = name;
    path = folder + "/socket";
    times = 0;
  }
  void TearDown() override {
    unlink(path.c_str());
    rmdir(folder.c_str());
  }
  int stranger() const {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path.copy(address.sun_path, sizeof address.sun_path - 1);
    const int file = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    EXPECT_EQ(connect(file, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    return file;
  }
  std::string folder;
  std::string path;
};

TEST_F(Sockets, OneThatAnotherProgramListensOnIsLeftAlone) {
  LinkPort first, second, host;
  std::thread listener([&] { EXPECT_TRUE(first.listen("unix:" + path, say)) << first.error(); });
  wait_until_said(1);
  struct stat status {};
  ASSERT_EQ(stat(path.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0600U);
  EXPECT_FALSE(second.listen("unix:" + path, say));
  EXPECT_NE(second.error().find("another program"), std::string::npos);
  ASSERT_TRUE(host.open("unix:" + path, 0)) << "it is still there, and was not disturbed";
  host.put(1);
  host.flush();
  listener.join();
  EXPECT_EQ(first.get(), 1);
  LinkPort late;
  EXPECT_FALSE(late.open("unix:" + path, 0)) << "one peer at a time";
}

TEST_F(Sockets, ALineIsOpenedAgainAndNothingOfTheOldOneIsLeft) {
  LinkPort host;
  for (int i = 1; i <= 2; ++i) {
    times = 0;
    LinkPort part;
    std::thread listener([&] { EXPECT_TRUE(part.listen("unix:" + path, say)) << part.error(); });
    wait_until_said(1);
    ASSERT_TRUE(host.open("unix:" + path, 0)) << host.error();
    EXPECT_EQ(host.error(), "");
    host.put(static_cast<std::uint8_t>(i));
    host.flush();
    listener.join();
    EXPECT_EQ(part.get(), i);
    part.put(static_cast<std::uint8_t>(10 + i));
    part.put(99);  // it is lost with the first line
    part.flush();
    EXPECT_EQ(host.get(), 10 + i);
    host.put(77);  // never flushed
    part.close();
  }
  EXPECT_EQ(host.get(), 99);
  EXPECT_EQ(host.get(), link::kClosed);
}

TEST_F(Sockets, NoPeerIsWaitedForBeyondTheTimeout) {
  LinkPort port;
  port.notice_cuts(50'000'000);
  EXPECT_FALSE(port.listen("unix:" + path, say));
  EXPECT_EQ(port.error(), "Connection timed out");
  EXPECT_FALSE(port.listen(":0", say));
  EXPECT_EQ(port.error(), "Connection timed out");
}

// A stopped process accepts no connection, and connect() would wait until it does.
TEST_F(Sockets, APeerThatDoesNotAcceptIsNotWaitedFor) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  path.copy(address.sun_path, sizeof address.sun_path - 1);
  const int file = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  ASSERT_EQ(bind(file, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  ASSERT_EQ(listen(file, 1), 0);
  LinkPort ports[4];
  int opened = 0;
  for (LinkPort& port : ports) opened += port.open("unix:" + path, 0) ? 1 : 0;
  EXPECT_LT(opened, 4);
  EXPECT_NE(ports[3].error(), "");
  close(file);
}

TEST_F(Sockets, AStaleOneIsReplacedAndAFileIsNot) {
  for (int i = 0; i < 2; ++i) {
    LinkPort port;
    times = 0;
    std::thread listener([&] { EXPECT_TRUE(port.listen("unix:" + path, say)) << port.error(); });
    wait_until_said(1);
    const int file = stranger();
    EXPECT_EQ(write(file, "x", 1), 1);
    listener.join();
    close(file);
  }
  unlink(path.c_str());
  close(open(path.c_str(), O_CREAT | O_WRONLY, 0600));
  LinkPort port;
  EXPECT_FALSE(port.listen("unix:" + path, say));
  EXPECT_EQ(access(path.c_str(), F_OK), 0);
}

TEST_F(Sockets, APeerThatSaysNothingIsDropped) {
  LinkPort port;
  std::thread listener([&] { EXPECT_TRUE(port.listen("unix:" + path, say)) << port.error(); });
  wait_until_said(1);
  const int silent = stranger();
  const int gone = stranger();
  close(gone);
  wait_until_said(3);
  const int file = stranger();
  EXPECT_EQ(write(file, "x", 1), 1);
  listener.join();
  EXPECT_EQ(port.get(), 'x');
  close(silent);
  close(file);
}

TEST(Tcp, WithoutAHostItIsForThisMachineOnly) {
  times = 0;
  LinkPort port;
  std::thread listener([&] { EXPECT_TRUE(port.listen(":0", say)) << port.error(); });
  wait_until_said(1);
  EXPECT_TRUE(said.starts_with("listens on 127.0.0.1:") || said.starts_with("listens on [::1]:"))
      << said;
  EXPECT_TRUE(said.ends_with(", for this machine only")) << said;
  LinkPort host;
  EXPECT_TRUE(
      host.open("localhost:" + std::to_string(std::stoi(said.substr(said.rfind(':') + 1))), 0))
      << host.error();
  host.put(1);
  host.flush();
  listener.join();
}

TEST(SerialLine, IsOpenedExclusively) {
  const int master = posix_openpt(O_RDWR | O_NOCTTY);
  const char* terminal = master >= 0 && unlockpt(master) == 0 ? ptsname(master) : nullptr;
  if (terminal == nullptr || access(terminal, R_OK | W_OK) != 0)
    GTEST_SKIP() << "this system has no pseudo-terminals";
  const std::string name = terminal;
  {
    LinkPort first, second;
    ASSERT_TRUE(first.open(name, 115200)) << first.error();
    EXPECT_FALSE(second.open(name, 115200));
  }
  LinkPort third;
  EXPECT_TRUE(third.open(name, 115200)) << "given back: " << third.error();
  close(master);
}

// A peer that does not read: the deadline of its answer is not put off until it does.
TEST_F(Sockets, WritersDoNotWaitForAPeerThatDoesNotRead) {
  LinkPort port;
  std::thread listener([&] { EXPECT_TRUE(port.listen("unix:" + path, say)) << port.error(); });
  wait_until_said(1);
  const int file = stranger();
  EXPECT_EQ(write(file, "x", 1), 1);
  listener.join();
  const std::uint64_t begun = LinkPort::now_ns();
  port.write_until(begun + 50'000'000);
  for (int i = 0; i < 3'000'000; ++i) port.put(0);
  port.flush();
  EXPECT_LT(LinkPort::now_ns() - begun, 900'000'000U);
  close(file);
}

/// A board that never answers, on a clock that advances by waiting.
struct SilentPort {
  std::uint64_t now = 0;
  std::uint64_t interrupted_ns = UINT64_MAX;
  void put(std::uint8_t /*byte*/) {}
  void flush() {}
  std::uint64_t now_ns() const { return now; }
  int get(std::uint64_t until_ns) {
    now = until_ns;
    return link::kNothing;
  }
  bool is_interrupted() const { return now >= interrupted_ns; }
};

TEST(HostLink, AnInterruptDoesNotWaitForASilentBoard) {
  constexpr std::uint64_t kMs = 1'000'000;
  link::HostLink<SilentPort, 64, 64> host;
  host.set_time_limit(5000 * kMs);
  EXPECT_FALSE(host.open({1, 1}, 1));
  EXPECT_GE(host.port.now, 5000 * kMs) << "no hurry";
  for (const std::uint64_t at : {0U, 600U}) {
    host.port.now = 0;
    host.port.interrupted_ns = at * kMs;
    EXPECT_FALSE(host.open({1, 1}, 1));
    EXPECT_EQ(host.problem(), link::Problem::no_answer);
    EXPECT_LE(host.port.now, (at + 300) * kMs);
    EXPECT_GE(host.port.now, (at + 200) * kMs) << "one that is there is heard";
  }
}

}  // namespace
}  // namespace eagerx::linux_sim
