#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
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
#include <targets/linux-sim/link_port.hpp>
#include <utility>

namespace eagerx::linux_sim {
namespace {

constexpr std::uint64_t kNsPerSecond = 1'000'000'000;
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

}  // namespace

bool LinkPort::fail(const std::string& what) {
  error_ = what;
  if (file_ >= 0) ::close(std::exchange(file_, -1));
  return false;
}

void LinkPort::close() {
  if (file_ >= 0) ::close(std::exchange(file_, -1));
}

std::uint64_t LinkPort::now_ns() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<std::uint64_t>(now.tv_sec) * kNsPerSecond +
         static_cast<std::uint64_t>(now.tv_nsec);
}

bool LinkPort::open(const std::string& address, std::uint32_t baud) {
  constexpr std::string_view kUnix = "unix:";
  if (address.starts_with(kUnix)) return open_unix(address.substr(kUnix.size()), false);
  struct stat status {};
  if (stat(address.c_str(), &status) == 0) {
    return S_ISSOCK(status.st_mode) ? open_unix(address, false) : open_serial(address, baud);
  }
  if (address.find('/') == std::string::npos && address.find(':') != std::string::npos)
    return open_tcp(address, false);
  return fail(std::strerror(errno));
}

bool LinkPort::listen(const std::string& address) {
  constexpr std::string_view kUnix = "unix:";
  if (address.starts_with(kUnix)) return open_unix(address.substr(kUnix.size()), true);
  return open_tcp(address, true);
}

bool LinkPort::accept_on(int listener) {
  const bool listening = ::listen(listener, 1) == 0;
  file_ = listening ? accept4(listener, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK) : -1;
  const int number = errno;
  ::close(listener);
  return file_ >= 0 || fail(std::strerror(number));
}

bool LinkPort::open_unix(const std::string& path, bool listens) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path) return fail("the path is too long for a socket");
  std::copy(path.begin(), path.end(), address.sun_path);
  const int file = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (file < 0) return fail(std::strerror(errno));
  const auto* const generic = reinterpret_cast<const sockaddr*>(&address);
  if (listens) {
    // Of an earlier run. Anything else of this name is somebody's, and bind() says so.
    struct stat status {};
    if (stat(path.c_str(), &status) == 0 && S_ISSOCK(status.st_mode)) unlink(path.c_str());
    if (bind(file, generic, sizeof address) == 0) return accept_on(file);
  } else if (connect(file, generic, sizeof address) == 0) {
    fcntl(file, F_SETFL, O_NONBLOCK);
    file_ = file;
    return true;
  }
  const int number = errno;
  ::close(file);
  return fail(std::strerror(number));
}

bool LinkPort::open_tcp(const std::string& address, bool listens) {
  const std::size_t colon = address.rfind(':');
  if (colon == std::string::npos) return fail("it is neither unix:PATH nor HOST:PORT");
  const std::string host = colon == 0 ? "localhost" : address.substr(0, colon);
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const int problem = getaddrinfo(host.c_str(), address.c_str() + colon + 1, &hints, &found);
  if (problem != 0) return fail(gai_strerror(problem));
  const std::unique_ptr<addrinfo, void (*)(addrinfo*)> owner(found, freeaddrinfo);
  int number = 0;
  for (const addrinfo* item = found; item != nullptr; item = item->ai_next) {
    const int file = socket(item->ai_family, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (file < 0) continue;
    const int yes = 1;
    if (listens) {
      setsockopt(file, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
      if (bind(file, item->ai_addr, item->ai_addrlen) == 0) return accept_on(file);
    } else if (connect(file, item->ai_addr, item->ai_addrlen) == 0) {
      setsockopt(file, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
      fcntl(file, F_SETFL, O_NONBLOCK);
      file_ = file;
      return true;
    }
    number = errno;
    ::close(file);
  }
  return fail(std::strerror(number));
}

bool LinkPort::open_serial(const std::string& path, std::uint32_t baud) {
  const speed_t speed = speed_of(baud);
  if (speed == B0) return fail("Linux has no such baud rate");
  file_ = ::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (file_ < 0) return fail(std::strerror(errno));
  termios settings{};
  if (tcgetattr(file_, &settings) != 0) return fail("it is no serial line");
  cfmakeraw(&settings);
  settings.c_cflag |= CLOCAL | CREAD;
  settings.c_cflag &= ~static_cast<tcflag_t>(CSTOPB | CRTSCTS);
  cfsetspeed(&settings, speed);
  if (tcsetattr(file_, TCSANOW, &settings) != 0) return fail(std::strerror(errno));
  tcflush(file_, TCIOFLUSH);
  return true;
}

bool LinkPort::wait(short events, std::uint64_t until_ns) {
  const std::uint64_t now = now_ns();
  if (now >= until_ns) return false;
  int timeout_ms = kForEver;
  if (until_ns != UINT64_MAX) {
    constexpr std::uint64_t kLongestMs = 1'000'000;
    timeout_ms = static_cast<int>(std::min((until_ns - now + kNsPerMs - 1) / kNsPerMs, kLongestMs));
  }
  pollfd item{file_, events, 0};
  return poll(&item, 1, timeout_ms) > 0;
}

void LinkPort::put(std::uint8_t byte) {
  if (out_size_ == out_.size()) flush();
  out_[out_size_++] = byte;
}

void LinkPort::flush() {
  constexpr std::uint64_t kPatienceNs = kNsPerSecond;
  const std::size_t size = std::exchange(out_size_, 0);
  const std::uint64_t until = now_ns() + kPatienceNs;
  for (std::size_t sent = 0; sent < size && file_ >= 0;) {
    const ssize_t count = write(file_, out_.data() + sent, size - sent);
    if (count > 0) {
      sent += static_cast<std::size_t>(count);
    } else if (errno != EAGAIN && errno != EINTR) {
      fail(std::strerror(errno));
    } else if (now_ns() >= until) {
      return;  // nobody reads: the frame is sent again, or the run ends for want of an answer
    } else {
      wait(POLLOUT, until);
    }
  }
}

void LinkPort::fill() {
  const ssize_t count = read(file_, in_.data(), in_.size());
  if (count > 0) {
    in_begin_ = 0;
    in_end_ = static_cast<std::size_t>(count);
  } else if (count == 0) {
    fail("the other end hung up");
  } else if (errno != EAGAIN && errno != EINTR) {
    fail(std::strerror(errno));
  }
}

int LinkPort::get(std::uint64_t until_ns) {
  while (in_begin_ == in_end_) {
    if (file_ < 0) return link::kClosed;
    if (now_ns() >= until_ns) return link::kNothing;
    if (wait(POLLIN, until_ns)) fill();
  }
  return in_[in_begin_++];
}

}  // namespace eagerx::linux_sim
