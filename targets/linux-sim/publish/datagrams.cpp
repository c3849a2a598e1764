#include <fcntl.h>
#include <netdb.h>
#include <unistd.h>

#include <array>
#include <charconv>
#include <cstring>
#include <targets/linux-sim/publish/datagrams.hpp>

namespace eagerx::linux_sim {
namespace {

void append(std::string& to, double value) {
  constexpr std::size_t kLongest = 32;
  std::array<char, kLongest> text{};
  to.append(text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr);
}

/// Names are letters, digits and `_`, but a library of one's own may be older than that rule.
void append_quoted(std::string& to, const std::string& name) {
  to += '"';
  for (const char c : name) {
    if (c == '"' || c == '\\') to += '\\';
    to += static_cast<unsigned char>(c) < ' ' ? '?' : c;
  }
  to += '"';
}

}  // namespace

Datagrams::~Datagrams() {
  if (socket_ >= 0) ::close(socket_);
}

std::string Datagrams::open(const Destination& destination) {
  const auto problem = [&](const char* why) {
    return "error: cannot publish to `" + destination.text + "`: " + why;
  };
  addrinfo wanted{};
  wanted.ai_socktype = SOCK_DGRAM;
  wanted.ai_flags = AI_NUMERICSERV;
  addrinfo* found = nullptr;
  const int code = getaddrinfo(destination.host.c_str(), destination.port.c_str(), &wanted, &found);
  if (code != 0) return problem(code == EAI_SYSTEM ? std::strerror(errno) : gai_strerror(code));
  socket_ = socket(found->ai_family, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  std::memcpy(&to_, found->ai_addr, found->ai_addrlen);
  to_bytes_ = found->ai_addrlen;
  freeaddrinfo(found);
  return socket_ < 0 ? problem(std::strerror(errno)) : "";
}

void Datagrams::send(const std::string& datagram) {
  const ssize_t sent =
      sendto(socket_, datagram.data(), datagram.size(), MSG_DONTWAIT | MSG_NOSIGNAL,
             reinterpret_cast<const sockaddr*>(&to_), to_bytes_);
  ++(sent < 0 ? lost_ : sent_);
}

void JsonDatagrams::begin(const Snapshot& snapshot) {
  node_.clear();
  text_ = "{\"timestamp\":";
  append(text_, snapshot.time_s);
  text_ += ",\"episode\":" + std::to_string(snapshot.episode);
  text_ += ",\"step\":" + std::to_string(snapshot.step);
}

void JsonDatagrams::add(const LatestMessage& message) {
  if (message.node != node_) {
    if (!node_.empty()) text_ += '}';
    node_ = message.node;
    text_ += ',';
    append_quoted(text_, node_);
    text_ += ":{";
  } else {
    text_ += ',';
  }
  append_quoted(text_, message.port);
  text_ += ':';
  if (message.size != 1) text_ += '[';
  for (std::size_t i = 0; i < message.size; ++i) {
    if (i > 0) text_ += ',';
    append_number(text_, message, i, "null");
  }
  if (message.size != 1) text_ += ']';
}

void JsonDatagrams::finish() {
  if (!node_.empty()) text_ += '}';
  node_.clear();
  text_ += '}';
}

void TeleplotLines::add(const Snapshot& snapshot, const LatestMessage& message, std::size_t i) {
  constexpr double kMsPerSecond = 1e3;
  const std::size_t begin = text_.size();
  text_ += message.channel->name;
  if (message.size != 1) text_ += '[' + std::to_string(i) + ']';
  text_ += ':';
  append(text_, snapshot.time_s * kMsPerSecond);
  text_ += ':';
  const std::size_t value = text_.size();
  append_number(text_, message, i, "");
  text_.size() == value ? text_.resize(begin) : text_.push_back('\n');
}

}  // namespace eagerx::linux_sim
