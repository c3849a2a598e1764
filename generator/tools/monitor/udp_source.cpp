#include <fmt/format.h>
#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <runtime/host/publish/address.hpp>
#include <runtime/host/publish/datagrams.hpp>
#include <utility>

#include "generator/tools/monitor/datagram.hpp"
#include "generator/tools/monitor/source.hpp"
#include "generator/tools/monitor/step_order.hpp"

namespace eagerx::gen {
namespace {

class UdpSource final : public Source {
 public:
  UdpSource(std::string name, int socket, std::string warning)
      : name_(std::move(name)), socket_(socket), warning_(std::move(warning)) {}
  ~UdpSource() override { ::close(socket_); }
  UdpSource(const UdpSource&) = delete;
  UdpSource& operator=(const UdpSource&) = delete;

  [[nodiscard]] int descriptor() const override { return socket_; }
  [[nodiscard]] std::string problem() const override { return problem_; }
  [[nodiscard]] std::string warning() const override { return warning_; }

  State read(std::int64_t now_ns, StreamListener& listener) override {
    constexpr int kMostAtOnce = 512;
    for (int i = 0; i < kMostAtOnce; ++i) {
      // With MSG_TRUNC the size is that of the datagram, also where there is no room for it.
      const ssize_t size = ::recv(socket_, bytes_.data(), bytes_.size(), MSG_TRUNC);
      if (size < 0) {
        if (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR) return State::open;
        problem_ = fmt::format("error: `{}`: {}", name_, std::strerror(errno));
        return State::failed;
      }
      const auto length = static_cast<std::size_t>(size);
      const auto datagram = length > bytes_.size()
                                ? std::nullopt
                                : read_datagram(std::string_view(bytes_.data(), length));
      if (datagram) {
        tell(*datagram, now_ns, listener);
      } else {
        listener.fault(StreamFault::damaged, 1);
      }
    }
    return State::more;
  }

 private:
  void tell(const Datagram& datagram, std::int64_t now_ns, StreamListener& listener) {
    using Place = StepOrder::Place;
    StepOrder order = order_;
    const Place place = order.place(datagram, now_ns);
    if (place == Place::foreign) return listener.fault(StreamFault::foreign, 1);
    if (place == Place::late) return listener.fault(StreamFault::late, 1);
    StreamFacts facts;
    facts.hash = datagram.graph_hash;
    facts.one_message_a_step = true;
    // A refused datagram changes nothing of a running stream.
    if (place == Place::first && !listener.begin(facts))
      return listener.fault(StreamFault::foreign, 1);
    order_ = order;
    if (order_.lost() > 0) listener.fault(StreamFault::lost, order_.lost());
    if (datagram.crowded_out > 0) listener.fault(StreamFault::crowded_out, datagram.crowded_out);
    const auto time_ns = static_cast<std::int64_t>(datagram.time_s * kNsInSecond);
    for (const DatagramMessage& message : datagram.messages) {
      listener.message({.channel = message.channel,
                        .values = message.values,
                        .elements = message.elements,
                        .episode = datagram.episode,
                        .seq = datagram.step,
                        .time_ns = time_ns,
                        .real_ns = now_ns});
    }
    if (place != Place::same) listener.step({datagram.episode, datagram.step, time_ns, now_ns});
  }

  const std::string name_;
  const int socket_;
  const std::string warning_;
  std::string problem_;
  StepOrder order_;
  std::array<char, publish::kMostDatagramBytes> bytes_{};
};

bool is_loopback(const addrinfo& address) {
  constexpr unsigned kShift = 24, kLoopbackNet = 127;
  if (address.ai_family == AF_INET) {
    sockaddr_in here{};
    std::memcpy(&here, address.ai_addr, sizeof(here));
    return (ntohl(here.sin_addr.s_addr) >> kShift) == kLoopbackNet;
  }
  if (address.ai_family != AF_INET6) return false;
  sockaddr_in6 here{};
  std::memcpy(&here, address.ai_addr, sizeof(here));
  return IN6_IS_ADDR_LOOPBACK(&here.sin6_addr);
}

/// A socket that is bound; -1: errno says why not.
int bound(const addrinfo& address) {
  constexpr int kBuffer = 1 << 20;
  const int made = ::socket(address.ai_family, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (made < 0) return made;
  // As much as the system gives: a screen may take its time.
  static_cast<void>(::setsockopt(made, SOL_SOCKET, SO_RCVBUF, &kBuffer, sizeof(kBuffer)));
  if (::bind(made, address.ai_addr, address.ai_addrlen) == 0) return made;
  const int why = errno;
  ::close(made);
  errno = why;
  return -1;
}

}  // namespace

std::unique_ptr<Source> open_udp_source(const std::string& name, std::string_view address,
                                        std::string& problem) {
  publish::Address at;
  if (!publish::parse_local_address(address, at)) {
    problem = fmt::format("error: `{}` is not a source\nhelp: `udp:PORT` or `udp:HOST:PORT`", name);
    return nullptr;
  }
  addrinfo hints{}, *found = nullptr;
  hints.ai_socktype = SOCK_DGRAM;
  hints.ai_flags = AI_NUMERICSERV | AI_PASSIVE;
  const int error = getaddrinfo(at.host.c_str(), at.port.c_str(), &hints, &found);
  if (error != 0) {
    problem =
        fmt::format("error: `{}`: there is no host `{}`: {}", name, at.host, gai_strerror(error));
    return nullptr;
  }
  const std::unique_ptr<addrinfo, void (*)(addrinfo*)> owned(found, freeaddrinfo);
  const int socket = bound(*found);
  if (socket < 0) {
    const bool taken = errno == EADDRINUSE;
    problem =
        fmt::format("error: cannot listen at `{}`: {}{}", name, std::strerror(errno),
                    taken ? "\nhelp: another program listens there; choose another port" : "");
    return nullptr;
  }
  std::string warning;
  if (!is_loopback(*found))
    warning = fmt::format("listens at `{}`: everybody who reaches it can send here", at.host);
  return std::make_unique<UdpSource>(name, socket, std::move(warning));
}

}  // namespace eagerx::gen
