#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <targets/linux-sim/link_port.hpp>
#include <targets/linux-sim/link_tcp.hpp>
#include <utility>

namespace eagerx::linux_sim {
namespace {

constexpr std::uint64_t kNsOfMs = 1'000'000;
constexpr std::uint64_t kNsOfSecond = 1'000'000'000;
constexpr std::uint64_t kLookAgainNs = 50 * kNsOfMs;  // for a request to end

/// Milliseconds from now on, rounded up.
int ms_until(std::uint64_t until_ns) {
  const std::uint64_t now = LinkPort::now_ns();
  constexpr std::uint64_t kLongestMs = 1'000'000;
  if (until_ns <= now) return 0;
  return static_cast<int>(std::min((until_ns - now + kNsOfMs - 1) / kNsOfMs, kLongestMs));
}

/// False: it is `until_ns`, or somebody wants the end.
bool wait_for_events(int file, short events, std::uint64_t until_ns) {
  while (!LinkPort::is_interrupted() && LinkPort::now_ns() < until_ns) {
    pollfd item{file, events, 0};
    const std::uint64_t look_ns = LinkPort::now_ns() + kLookAgainNs;
    if (poll(&item, 1, ms_until(std::min(until_ns, look_ns))) > 0) return true;
  }
  return false;
}

/// A new connection always has room for a greeting.
bool send_all(int file, key::Bytes bytes) {
  return send(file, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT) ==
         static_cast<ssize_t>(bytes.size());
}

enum class Step : std::uint8_t { continues, hung_up, wrong };

/// Reads what is there of a greeting, and answers it.
Step take_step(int file, key::Greeting& greeting) {
  std::array<std::uint8_t, key::Greeting::kMostBytes> bytes{};
  const ssize_t count = recv(file, bytes.data(), greeting.wanted(), MSG_DONTWAIT);
  if (count < 0) return errno == EAGAIN || errno == EINTR ? Step::continues : Step::hung_up;
  if (count == 0) return Step::hung_up;
  if (!greeting.take({bytes.data(), static_cast<std::size_t>(count)})) return Step::wrong;
  const key::Bytes answer = greeting.to_send();
  if (!answer.empty() && !send_all(file, answer)) return Step::hung_up;
  greeting.sent();
  return Step::continues;
}

/// A connection that is not authenticated yet.
struct Unknown {
  int file = -1;
  std::uint64_t until_ns = 0;
  key::Greeting greeting;
};

class Door {
 public:
  static constexpr std::size_t kMost = 16;

  Door(int listener, const KeyInUse& key, int greeting_s, void (*say)(const std::string& text))
      : listener_(listener), key_(key), greeting_s_(greeting_s), say_(say) {}
  Door(const Door&) = delete;
  Door& operator=(const Door&) = delete;
  ~Door() {
    for (Unknown& each : unknown_)
      if (each.file >= 0) ::close(each.file);
  }

  /// The socket of the peer that has the key; -1: errno says why there is none.
  int wait(std::uint64_t most_ns, key::Records& records) {
    for (;;) {
      if (LinkPort::now_ns() >= most_ns) return errno = ETIMEDOUT, -1;
      std::array<pollfd, kMost + 1> items{};
      std::uint64_t until_ns = std::min(most_ns, LinkPort::now_ns() + kLookAgainNs * kMost);
      for (std::size_t i = 0; i < kMost; ++i) {
        items[i] = {unknown_[i].file, POLLIN, 0};  // -1 is left out
        if (unknown_[i].file >= 0) until_ns = std::min(until_ns, unknown_[i].until_ns);
      }
      items[kMost] = {listener_, POLLIN, 0};
      const int ready = poll(items.data(), items.size(), ms_until(until_ns));
      if (ready < 0 && errno != EINTR) return -1;
      if (LinkPort::is_interrupted()) return errno = EINTR, -1;
      for (std::size_t i = 0; i < kMost; ++i)
        if (ready > 0 && items[i].revents != 0 && is_known(unknown_[i]))
          return unknown_[i].greeting.go_on(records), std::exchange(unknown_[i].file, -1);
      drop_late();
      if (ready > 0 && items[kMost].revents != 0 && !let_in()) return -1;
    }
  }

 private:
  bool is_known(Unknown& who) {
    const Step step = take_step(who.file, who.greeting);
    if (step == Step::hung_up) drop(who, "hung up before it authenticated");
    if (step == Step::wrong) drop(who, "does not have the key");
    return step == Step::continues && who.greeting.is_done();
  }
  void drop_late() {
    const std::uint64_t now = LinkPort::now_ns();
    for (Unknown& each : unknown_)
      if (each.file >= 0 && each.until_ns <= now)
        drop(each, "did not authenticate within " + std::to_string(greeting_s_) + " s");
  }
  void drop(Unknown& who, const std::string& why) {
    ::close(std::exchange(who.file, -1));
    who.greeting.forget();
    // Repeated connections fill no disk.
    constexpr std::uint64_t kBase = 10;
    if (++dropped_ != next_note_) return;
    next_note_ *= kBase;
    say_("note: dropped a peer that " + why +
         (dropped_ == 1 ? std::string() : "; " + std::to_string(dropped_) + " dropped so far"));
  }
  /// False: nothing can be accepted any more.
  bool let_in() {
    const int file = accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
    // An error of a connection is not an error of the listener (accept(2)).
    if (file < 0) return errno != EBADF && errno != EINVAL && errno != ENOTSOCK && errno != EMFILE;
    const auto oldest = std::ranges::min_element(
        unknown_, {}, [](const Unknown& each) { return each.file < 0 ? 0 : each.until_ns; });
    if (oldest->file >= 0) drop(*oldest, "waited longest of too many");
    oldest->file = file;
    oldest->until_ns = LinkPort::now_ns() + static_cast<std::uint64_t>(greeting_s_) * kNsOfSecond;
    oldest->greeting.begin(*key_.sodium, key_.key, key::Role::listens);
    return true;
  }

  int listener_;
  const KeyInUse& key_;
  int greeting_s_;
  void (*say_)(const std::string& text);
  std::array<Unknown, kMost> unknown_{};
  std::uint64_t dropped_ = 0, next_note_ = 1;
};

}  // namespace

bool is_of_this_machine(const sockaddr* address) {
  constexpr std::uint32_t kNet = 127;
  constexpr unsigned kBelow = 24;
  if (address->sa_family == AF_INET) {
    const auto* const four = reinterpret_cast<const sockaddr_in*>(address);
    return ntohl(four->sin_addr.s_addr) >> kBelow == kNet;
  }
  if (address->sa_family != AF_INET6) return false;
  const in6_addr& six = reinterpret_cast<const sockaddr_in6*>(address)->sin6_addr;
  constexpr std::size_t kFourBegins = 12;
  return IN6_IS_ADDR_LOOPBACK(&six) ||
         (IN6_IS_ADDR_V4MAPPED(&six) && six.s6_addr[kFourBegins] == kNet);
}

std::string address_of_end(int file) {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  char host[NI_MAXHOST] = "";
  char port[NI_MAXSERV] = "";
  auto* const generic = reinterpret_cast<sockaddr*>(&address);
  if (getsockname(file, generic, &size) != 0 ||
      getnameinfo(generic, size, host, sizeof host, port, sizeof port,
                  NI_NUMERICHOST | NI_NUMERICSERV) != 0)
    return "a port";
  const std::string name = host;
  return (name.find(':') == std::string::npos ? name : "[" + name + "]") + ":" + port;
}

bool is_tcp_address(const std::string& address) {
  return !address.starts_with("unix:") && address.find('/') == std::string::npos &&
         address.find(':') != std::string::npos;
}

int connect_until(int file, const sockaddr* address, socklen_t size, std::uint64_t until_ns) {
  if (connect(file, address, size) == 0) return 0;
  if (errno != EINPROGRESS) return errno;
  if (!wait_for_events(file, POLLOUT, until_ns)) return ETIMEDOUT;
  int number = 0;
  socklen_t bytes = sizeof number;
  return getsockopt(file, SOL_SOCKET, SO_ERROR, &number, &bytes) == 0 ? number : errno;
}

std::string greet(int file, const KeyInUse& key, std::uint64_t until_ns, key::Records& records) {
  key::Greeting greeting;
  greeting.begin(*key.sodium, key.key, key::Role::connects);
  Step step = send_all(file, greeting.to_send()) ? Step::continues : Step::hung_up;
  greeting.sent();
  while (step == Step::continues && !greeting.is_done()) {
    if (!wait_for_events(file, POLLIN, until_ns))
      return "the peer did not authenticate in time\n"
             "help: start it with `--key` and the same key";
    step = take_step(file, greeting);
  }
  if (step == Step::hung_up)
    return "the peer hung up before it authenticated\n"
           "help: start it with `--key` and the same key";
  if (step == Step::wrong)
    return "the peer does not have this key, or a third party changes the data\n"
           "help: both sides need the same key, of one `eagerx-gen key new FILE`";
  greeting.go_on(records);
  return {};
}

int accept_known(int listener, const KeyInUse& key, int greeting_s, std::uint64_t until_ns,
                 void (*say)(const std::string& text), key::Records& records) {
  fcntl(listener, F_SETFL, O_NONBLOCK);
  return Door(listener, key, greeting_s, say).wait(until_ns, records);
}

}  // namespace eagerx::linux_sim
