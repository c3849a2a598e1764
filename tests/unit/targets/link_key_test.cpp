// targets/linux-sim/link_port.hpp with a key: who is let in, and what a sealed line does.
#include <arpa/inet.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "targets/linux-sim/keys.hpp"
#include "targets/linux-sim/link_port.hpp"

namespace eagerx::linux_sim {
namespace {

std::mutex notes_lock;
std::vector<std::string> notes;  // of the thread that listens
void note(const std::string& text) {
  const std::lock_guard guard(notes_lock);
  notes.push_back(text);
}
std::string note_number(std::size_t index) {
  for (int i = 0; i < 1000; ++i) {
    {
      const std::lock_guard guard(notes_lock);
      if (notes.size() > index) return notes[index];
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return "nothing was said";
}

KeyInUse key_with(std::uint8_t byte) {
  std::string problem;
  KeyInUse key;
  key.sodium = key::sodium(problem);
  EXPECT_EQ(problem, "");
  key.key.fill(byte);
  return key;
}

class KnownPeer : public ::testing::Test {
 protected:
  void SetUp() override {
    notes.clear();
    listening.use_key(key_with(1));
    connecting.use_key(key_with(1));
    listener = std::thread([&] { listens = listening.listen("127.0.0.1:0", note); });
    const std::string first = note_number(0);
    ASSERT_TRUE(first.ends_with(", for holders of the key")) << first;
    port = std::stoi(first.substr(first.rfind(':') + 1));
  }
  void TearDown() override {
    if (!listener.joinable()) return;
    connect_known();
  }
  std::string address() const { return "127.0.0.1:" + std::to_string(port); }
  void connect_known() {
    EXPECT_TRUE(connecting.open(address(), 0)) << connecting.error();
    listener.join();
    EXPECT_TRUE(listens) << listening.error();
  }
  int stranger(const std::string& says) const {
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(static_cast<std::uint16_t>(port));
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const int file = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    EXPECT_EQ(connect(file, reinterpret_cast<const sockaddr*>(&to), sizeof to), 0);
    EXPECT_EQ(send(file, says.data(), says.size(), MSG_NOSIGNAL),
              static_cast<ssize_t>(says.size()));
    return file;
  }
  LinkPort listening, connecting;
  std::thread listener;
  bool listens = false;
  int port = 0;
};

TEST_F(KnownPeer, IsLetInPastStrangersAndOneWithAnotherKey) {
  std::vector<int> strangers;
  for (const char* says : {"", "eagerx", "GET / HTTP/1.1\r\n\r\n"})
    for (int i = 0; i < 20; ++i) strangers.push_back(stranger(says));
  EXPECT_NE(note_number(1).find("note: dropped a peer that "), std::string::npos);
  LinkPort other;
  other.use_key(key_with(2));
  EXPECT_FALSE(other.open(address(), 0));
  EXPECT_NE(other.error().find("does not have this key"), std::string::npos) << other.error();
  connect_known();
  for (const int file : strangers) close(file);
  connecting.put('a');
  connecting.flush();
  EXPECT_EQ(listening.get(), 'a');
  EXPECT_LT(notes.size(), 5U) << "repeated connections are noted ever more rarely";
}

TEST_F(KnownPeer, EveryByteComesInItsOrderAndThenTheEnd) {
  connect_known();
  constexpr int kBytes = 100'000;
  std::thread writer([&] {
    for (int i = 0; i < kBytes; ++i) connecting.put(static_cast<std::uint8_t>(i * 31 + i / 256));
    connecting.flush();
    connecting.close();
  });
  int wrong = 0;
  for (int i = 0; i < kBytes; ++i)
    wrong += listening.get() != static_cast<std::uint8_t>(i * 31 + i / 256);
  writer.join();
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(listening.get(), link::kClosed);
  EXPECT_EQ(listening.error(), "the other end hung up");
}

// A frame that is out of time is left out as a whole; what is under way has its end before the
// next.
TEST_F(KnownPeer, WhoDoesNotReadIsNotWaitedForAndLosesNoOrder) {
  connect_known();
  const std::uint64_t begun = LinkPort::now_ns();
  connecting.write_until(begun + 50'000'000);
  for (int i = 0; i < 8'000'000; ++i) connecting.put(1);
  connecting.flush();
  EXPECT_LT(LinkPort::now_ns() - begun, 5'000'000'000U);
  std::thread reader([&] {
    int byte = 1;
    while (byte == 1) byte = listening.get();
    EXPECT_EQ(byte, 2) << listening.error();
  });
  connecting.write_until(UINT64_MAX);
  connecting.flush();
  connecting.put(2);
  connecting.flush();
  reader.join();
}

TEST_F(KnownPeer, NeedsALibraryAndAFileOfItsOwn) {
  LinkPort other;
  EXPECT_NE(use_key_of("/nowhere/a.key", address(), other).find("error: cannot use the key"),
            std::string::npos);
  EXPECT_NE(use_key_of("/nowhere/a.key", "unix:/tmp/x", other).find("does nothing"),
            std::string::npos);
}

TEST(TcpBeyondThisMachine, NeedsAKey) {
  LinkPort port;
  for (const char* address : {"192.0.2.1:7001", "0.0.0.0:0", "[::]:0", "[2001:db8::1]:7001"}) {
    EXPECT_FALSE(port.open(address, 0));
    EXPECT_EQ(port.error(), kNeedsKey) << address;
    EXPECT_FALSE(port.listen(address, note));
    EXPECT_EQ(port.error(), kNeedsKey) << address;
  }
}

TEST(TcpBeyondThisMachine, IsWhatNoLoopbackIs) {
  const auto four = [](const char* text) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    inet_pton(AF_INET, text, &address.sin_addr);
    return is_of_this_machine(reinterpret_cast<const sockaddr*>(&address));
  };
  const auto six = [](const char* text) {
    sockaddr_in6 address{};
    address.sin6_family = AF_INET6;
    inet_pton(AF_INET6, text, &address.sin6_addr);
    return is_of_this_machine(reinterpret_cast<const sockaddr*>(&address));
  };
  EXPECT_TRUE(four("127.0.0.1") && four("127.255.255.254") && six("::1") &&
              six("::ffff:127.0.0.1"));
  EXPECT_FALSE(four("0.0.0.0") || four("126.255.255.255") || four("128.0.0.1") ||
               four("192.168.1.1") || six("::") || six("::2") || six("::ffff:128.0.0.1") ||
               six("fe80::1"));
  sockaddr other{};
  other.sa_family = AF_UNIX;
  EXPECT_FALSE(is_of_this_machine(&other));
}

TEST(TcpBeyondThisMachine, HasAnAddressOfThisForm) {
  EXPECT_TRUE(is_tcp_address("host:7001") && is_tcp_address(":7001") && is_tcp_address("[::1]:1"));
  EXPECT_FALSE(is_tcp_address("unix:path") || is_tcp_address("/dev/ttyUSB0") ||
               is_tcp_address("/a:b") || is_tcp_address("host"));
}

}  // namespace
}  // namespace eagerx::linux_sim
