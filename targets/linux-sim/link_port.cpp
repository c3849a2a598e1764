#include <fcntl.h>
#include <netdb.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <memory>
#include <runtime/host/base/interrupt.hpp>
#include <runtime/host/base/supervisor.hpp>
#include <targets/linux-sim/link_port.hpp>
#include <utility>

namespace eagerx::linux_sim {
namespace {

constexpr std::uint64_t kSecondNs = 1'000'000'000;
constexpr std::uint64_t kNsPerMs = 1'000'000;
constexpr int kForEver = -1;

speed_t speed_of(std::uint32_t baud) {
  constexpr std::pair<std::uint32_t, speed_t> kSpeeds[] = {
      {9600, B9600},       {19200, B19200},     {38400, B38400},     {57600, B57600},
      {115200, B115200},   {230400, B230400},   {460800, B460800},   {921600, B921600},
      {1000000, B1000000}, {2000000, B2000000}, {3000000, B3000000}, {4000000, B4000000}};
  for (const auto& [value, speed] : kSpeeds) {
    if (value == baud) return speed;
  }
  return B0;
}

constexpr std::string_view kUnix = "unix:";

/// Whether a program listens on the socket `address`, without disturbing it: a datagram cannot be
/// sent to a stream, which only a living one says. Sockets of other users that we may not ask
/// count.
bool is_alive(const sockaddr_un& address) {
  const int file = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (file < 0) return true;
  const int result = connect(file, reinterpret_cast<const sockaddr*>(&address), sizeof address);
  const bool refused = result != 0 && errno == ECONNREFUSED;
  ::close(file);
  return !refused;
}

/// Two programs that begin at once must not remove each other's socket: the folder is locked.
class FolderLock {
 public:
  explicit FolderLock(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    const std::string folder = slash == std::string::npos ? "." : path.substr(0, slash + 1);
    file_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (file_ >= 0) flock(file_, LOCK_EX);
  }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock() {
    if (file_ >= 0) ::close(file_);
  }

 private:
  int file_;
};

/// Only its owner may connect, from the first moment on. Returns errno, 0: it listens.
int listen_at(int file, const sockaddr_un& address) {
  const FolderLock lock(address.sun_path);
  // A stale socket is of an earlier run. Anything else of this name is somebody's.
  struct stat status {};
  if (lstat(address.sun_path, &status) == 0) {
    if (!S_ISSOCK(status.st_mode) || is_alive(address)) return EADDRINUSE;
    unlink(address.sun_path);
  }
  constexpr mode_t kOwnerOnly = 0600;
  const bool listens =
      fchmod(file, kOwnerOnly) == 0 &&
      bind(file, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 &&
      ::listen(file, 1) == 0;
  return listens ? 0 : errno;
}

}  // namespace

bool LinkPort::fail(const std::string& what) {
  error_ = what;
  close();
  return false;
}

void LinkPort::close() {
  if (file_ < 0) return;
  if (records_.is_open()) {
    // Announces a regular end to the other end, as opposed to a cut line.
    if (sealed_begin_ == sealed_end_)
      static_cast<void>(send(file_, sealed_.data(), records_.seal(nullptr, 0, sealed_.data()),
                             MSG_NOSIGNAL | MSG_DONTWAIT));
    records_.forget();
  }
  if (std::exchange(is_serial_, false)) ioctl(file_, TIOCNXCL);
  ::close(std::exchange(file_, -1));
}

bool LinkPort::is_interrupted() {
  host::stop_if_requested();
  return host::interrupted();
}

std::uint64_t LinkPort::now_ns() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<std::uint64_t>(now.tv_sec) * kSecondNs +
         static_cast<std::uint64_t>(now.tv_nsec);
}

/// Nothing of an earlier line is left.
void LinkPort::begin_anew() {
  close();
  error_.clear();
  is_forged_ = false;
  in_begin_ = in_end_ = out_size_ = 0;
  sealed_begin_ = sealed_end_ = 0;
}

std::uint64_t LinkPort::accept_until() const {
  return most_wait_ns_ == UINT64_MAX ? UINT64_MAX : now_ns() + most_wait_ns_;
}

/// Of a connection. An answer waits for no other one; a unix socket knows no such wait.
void LinkPort::set_options() const {
  const int yes = 1;
  setsockopt(file_, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
  if (!notices_cuts_) return;
  constexpr int kMsPerSecond = 1'000;
  const int looks = kCutS, each_s = 1, most_ms = kCutS * kMsPerSecond;
  setsockopt(file_, SOL_SOCKET, SO_KEEPALIVE, &yes, sizeof yes);
  setsockopt(file_, IPPROTO_TCP, TCP_KEEPIDLE, &each_s, sizeof each_s);
  setsockopt(file_, IPPROTO_TCP, TCP_KEEPINTVL, &each_s, sizeof each_s);
  setsockopt(file_, IPPROTO_TCP, TCP_KEEPCNT, &looks, sizeof looks);
  setsockopt(file_, IPPROTO_TCP, TCP_USER_TIMEOUT, &most_ms, sizeof most_ms);
}

bool LinkPort::open(const std::string& address, std::uint32_t baud) {
  begin_anew();
  if (address.starts_with(kUnix)) return open_unix(address.substr(kUnix.size()), nullptr);
  struct stat status {};
  if (stat(address.c_str(), &status) == 0) {
    return S_ISSOCK(status.st_mode) ? open_unix(address, nullptr) : open_serial(address, baud);
  }
  if (is_tcp_address(address)) return open_tcp(address, nullptr);
  return fail(std::strerror(errno));
}

bool LinkPort::listen(const std::string& address, Say say) {
  begin_anew();
  if (address.starts_with(kUnix)) return open_unix(address.substr(kUnix.size()), say);
  return open_tcp(address, say);
}

/// Others who connect meanwhile are refused when the listener is closed: once the peer has spoken.
bool LinkPort::accept_on(int listener, Say say) {
  int number = 0;
  const std::uint64_t most = accept_until();
  while (file_ < 0 && number == 0) {
    if (most != UINT64_MAX && !wait_on(listener, POLLIN, most)) {
      if (now_ns() >= most) number = ETIMEDOUT;
      continue;
    }
    file_ = accept4(listener, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
    if (file_ < 0) {
      number = errno == EINTR || errno == ECONNABORTED ? 0 : errno;
      continue;
    }
    set_options();
    const std::uint64_t until = now_ns() + kGreetingS * kSecondNs;
    bool has_spoken = false;
    while (!has_spoken && now_ns() < until) has_spoken = wait(POLLIN, until);
    if (has_spoken) {
      std::uint8_t first = 0;
      if (recv(file_, &first, 1, MSG_PEEK) > 0) break;
      say("note: a peer hung up before it sent anything");
    } else {
      say("note: a peer said nothing for " + std::to_string(kGreetingS) + " s and was dropped");
    }
    close();
  }
  ::close(listener);
  return file_ >= 0 || fail(std::strerror(number));
}

bool LinkPort::open_unix(const std::string& path, Say say) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path) return fail("the path is too long for a socket");
  std::copy(path.begin(), path.end(), address.sun_path);
  // Who listens and has no time for us is not waited for.
  const int waits = say != nullptr ? 0 : SOCK_NONBLOCK;
  const int file = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | waits, 0);
  if (file < 0) return fail(std::strerror(errno));
  int number = 0;
  if (say != nullptr) {
    number = listen_at(file, address);
    if (number == 0) return say("listens on unix:" + path), accept_on(file, say);
  } else if (connect(file, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) {
    file_ = file;
    return true;
  } else {
    number = errno;
  }
  ::close(file);
  return fail(number == EADDRINUSE ? "another program listens on it, or it is not a socket"
                                   : std::strerror(number));
}

bool LinkPort::open_tcp(const std::string& address, Say say) {
  const std::size_t colon = address.rfind(':');
  if (colon == std::string::npos) return fail("it is neither unix:PATH nor HOST:PORT");
  const bool is_local = colon == 0;
  std::string host = is_local ? "localhost" : address.substr(0, colon);
  if (host.starts_with('[') && host.ends_with(']')) host = host.substr(1, host.size() - 2);
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const int problem = getaddrinfo(host.c_str(), address.c_str() + colon + 1, &hints, &found);
  if (problem != 0) return fail(gai_strerror(problem));
  const std::unique_ptr<addrinfo, void (*)(addrinfo*)> owner(found, freeaddrinfo);
  int number = 0;
  for (const addrinfo* item = found; item != nullptr; item = item->ai_next) {
    if (key_.sodium == nullptr && !is_of_this_machine(item->ai_addr)) return fail(kNeedsKey);
    const int waits = say != nullptr ? 0 : SOCK_NONBLOCK;
    const int file = socket(item->ai_family, SOCK_STREAM | SOCK_CLOEXEC | waits, 0);
    if (file < 0) continue;
    const int yes = 1;
    if (say != nullptr) {
      constexpr int kWaiting = 128;  // strangers who wait to be dropped
      setsockopt(file, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
      if (bind(file, item->ai_addr, item->ai_addrlen) == 0 &&
          ::listen(file, key_.sodium == nullptr ? 1 : kWaiting) == 0) {
        say("listens on " + address_of_end(file) +
            (key_.sodium != nullptr ? ", for holders of the key"
             : is_local             ? ", for this machine only"
                                    : ""));
        return key_.sodium != nullptr ? accept_sealed(file, say) : accept_on(file, say);
      }
      number = errno;
    } else {
      number =
          connect_until(file, item->ai_addr, item->ai_addrlen, now_ns() + kGreetingS * kSecondNs);
      if (number == 0) {
        setsockopt(file, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
        file_ = file;
        return begin_session();
      }
    }
    ::close(file);
  }
  return fail(std::strerror(number));
}

bool LinkPort::accept_sealed(int listener, Say say) {
  file_ = accept_known(listener, key_, kGreetingS, accept_until(), say, records_);
  const int number = errno;
  ::close(listener);
  if (file_ < 0) return fail(std::strerror(number));
  set_options();
  return true;
}

/// Of who connects.
bool LinkPort::begin_session() {
  if (key_.sodium == nullptr) return true;
  const std::string problem = greet(file_, key_, now_ns() + kGreetingS * kSecondNs, records_);
  return problem.empty() || fail(problem);
}

bool LinkPort::open_serial(const std::string& path, std::uint32_t baud) {
  const speed_t speed = speed_of(baud);
  if (speed == B0) return fail("Linux has no such baud rate");
  file_ = ::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (file_ < 0) return fail(std::strerror(errno));
  termios settings{};
  if (tcgetattr(file_, &settings) != 0) return fail("it is not a serial line");
  // The lock also keeps root out, who is not bound by TIOCEXCL.
  if (flock(file_, LOCK_EX | LOCK_NB) != 0) return fail("another program uses it");
  ioctl(file_, TIOCEXCL);
  is_serial_ = true;
  cfmakeraw(&settings);
  settings.c_cflag |= CLOCAL | CREAD;
  settings.c_cflag &= ~static_cast<tcflag_t>(CSTOPB | CRTSCTS);
  cfsetspeed(&settings, speed);
  if (tcsetattr(file_, TCSANOW, &settings) != 0) return fail(std::strerror(errno));
  tcflush(file_, TCIOFLUSH);
  return true;
}

bool LinkPort::wait(short events, std::uint64_t until_ns) {
  return wait_on(file_, events, until_ns);
}

bool LinkPort::wait_on(int file, short events, std::uint64_t until_ns) {
  const std::uint64_t now = now_ns();
  if (now >= until_ns) return false;
  int timeout_ms = kForEver;
  if (until_ns != UINT64_MAX) {
    constexpr std::uint64_t kLongestMs = 1'000'000;
    timeout_ms = static_cast<int>(std::min((until_ns - now + kNsPerMs - 1) / kNsPerMs, kLongestMs));
  }
  pollfd item{file, events, 0};
  return poll(&item, 1, timeout_ms) > 0;
}

void LinkPort::put(std::uint8_t byte) {
  if (out_size_ == out_.size()) flush();
  out_[out_size_++] = byte;
}

void LinkPort::flush() {
  constexpr std::uint64_t kPatienceNs = kSecondNs;
  const std::size_t size = std::exchange(out_size_, 0);
  const std::uint64_t until = std::min(now_ns() + kPatienceNs, write_until_ns_);
  if (!records_.is_open()) {
    // The peer does not read: the frame is sent again, or the run ends for want of an answer.
    write_bytes(out_.data(), size, until);
  } else if (send_sealed(until) && size > 0) {
    sealed_begin_ = 0;
    sealed_end_ = records_.seal(out_.data(), size, sealed_.data());
    send_sealed(until);
  }
}

/// How many of the bytes are written by then.
std::size_t LinkPort::write_bytes(const std::uint8_t* bytes, std::size_t size,
                                  std::uint64_t until_ns) {
  std::size_t sent = 0;
  while (sent < size && file_ >= 0) {
    const ssize_t count = write(file_, bytes + sent, size - sent);
    if (count > 0) {
      sent += static_cast<std::size_t>(count);
    } else if (errno != EAGAIN && errno != EINTR) {
      fail(std::strerror(errno));
    } else if (now_ns() >= until_ns) {
      break;
    } else {
      constexpr std::uint64_t kLookNs = 50 * kNsPerMs;
      host::send_heartbeat();
      wait(POLLOUT, std::min(until_ns, now_ns() + kLookNs));
    }
  }
  return sent;
}

/// A sealed frame has its place in the order, so it has to go before anything else: a frame that is
/// out of time is never sealed. Whether all of it went.
bool LinkPort::send_sealed(std::uint64_t until_ns) {
  sealed_begin_ +=
      write_bytes(sealed_.data() + sealed_begin_, sealed_end_ - sealed_begin_, until_ns);
  return sealed_begin_ == sealed_end_;
}

/// False: more bytes are needed.
bool LinkPort::open_record() {
  using Found = key::Records::Found;
  in_begin_ = in_end_ = 0;
  switch (records_.open(in_.data(), in_end_)) {
    case Found::record:
      return true;
    case Found::end:
      return fail("the other end hung up");
    case Found::forged:
      is_forged_ = true;
      return fail("a third party changed, repeated or removed data");
    case Found::nothing:
      break;
  }
  return false;
}

void LinkPort::fill() {
  const bool is_sealed = records_.is_open();
  std::uint8_t* const to = is_sealed ? records_.room().data() : in_.data();
  const ssize_t count = read(file_, to, is_sealed ? records_.room().size() : in_.size());
  if (count > 0 && is_sealed) {
    records_.take(static_cast<std::size_t>(count));
  } else if (count > 0) {
    in_begin_ = 0;
    in_end_ = static_cast<std::size_t>(count);
  } else if (count == 0) {
    fail(is_sealed ? "it was cut: the other end died, or a third party cut it"
                   : "the other end hung up");
  } else if (errno != EAGAIN && errno != EINTR) {
    fail(std::strerror(errno));
  }
}

int LinkPort::get(std::uint64_t until_ns) {
  while (in_begin_ == in_end_) {
    if (file_ >= 0 && records_.is_open() && open_record()) continue;
    if (file_ < 0) return link::kClosed;
    if (now_ns() >= until_ns) return link::kNothing;
    if (wait(POLLIN, until_ns)) fill();
  }
  return in_[in_begin_++];
}

}  // namespace eagerx::linux_sim
