// Whatever comes in from a line: frames, both ends of a link.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <eagerx/link/board.hpp>
#include <eagerx/link/host.hpp>
#include <memory>
#include <vector>

namespace {

using namespace eagerx;

struct Port {
  const std::uint8_t* at = nullptr;
  const std::uint8_t* end = nullptr;
  std::uint64_t now = 0;

  void put(std::uint8_t /*byte*/) {}
  void flush() {}
  std::uint64_t now_ns() const { return now; }
  int get() { return at == end ? link::kClosed : *at++; }
  int get(std::uint64_t until_ns) {
    if (at == end) now = until_ns;
    return at == end ? link::kNothing : *at++;
  }
};

constexpr std::size_t kToBoard = 32;
constexpr std::size_t kToHost = 24;
constexpr link::Identity kIdentity{0x0123456789abcdefU, 1};

/// Encoded bytes read back, and noise becomes no longer.
void check_cobs(const std::uint8_t* data, std::size_t size) {
  std::vector<std::uint8_t> line;
  link::cobs_encode(data, size, [&](std::uint8_t byte) { line.push_back(byte); });
  if (line.size() > link::cobs_bound(size)) std::abort();
  line.resize(link::cobs_decode(line.data(), line.size()));
  if (line != std::vector<std::uint8_t>(data, data + size)) std::abort();
  std::vector<std::uint8_t> noise(data, data + size);
  if (link::cobs_decode(noise.data(), noise.size()) > size) std::abort();
}

void run_board(const std::uint8_t* data, std::size_t size) {
  auto board = std::make_unique<link::BoardLink<Port, kToBoard, kToHost>>();
  board->port.at = data;
  board->port.end = data + size;
  board->identify(kIdentity, 0);
  while (board->wait_for_host()) {
    bool flag = false;
    Array<float, 20> values{};
    while (board->get(flag) && board->get(values)) {
      board->put(values);
      board->put(flag);
    }
  }
}

void run_host(const std::uint8_t* data, std::size_t size) {
  auto host = std::make_unique<link::HostLink<Port, kToBoard, kToHost>>();
  host->port.at = data;
  host->port.end = data + size;
  if (!host->open(kIdentity, 1)) return;
  Array<float, 20> values{};
  while (host->ok()) {
    host->begin_step();
    host->put(values);
    host->get(values);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  check_cobs(data, size);
  // With a greeting in front that begins a session, and without.
  link::Greeting greeting;
  greeting.runtime = kIdentity.runtime;
  greeting.graph = kIdentity.graph;
  greeting.session = 1;
  std::uint8_t bytes[link::Greeting::kBytes];
  greeting.write(bytes);
  for (const link::Kind kind : {link::Kind::hello, link::Kind::welcome}) {
    auto frame = std::make_unique<link::OutFrame<kToBoard>>();
    frame->append(bytes, sizeof bytes);
    frame->seal(kind, 0, 0);
    std::vector<std::uint8_t> line;
    frame->send([&](std::uint8_t byte) { line.push_back(byte); });
    // The first bytes are the payload of a frame that is intact, the others come as they are.
    const std::size_t payload = size < kToHost ? size : kToHost;
    frame->clear();
    frame->append(data, payload);
    frame->seal(kind == link::Kind::hello ? link::Kind::request : link::Kind::answer, 1,
                greeting.crc_start());
    frame->send([&](std::uint8_t byte) { line.push_back(byte); });
    line.insert(line.end(), data + payload, data + size);
    kind == link::Kind::hello ? run_board(line.data(), line.size())
                              : run_host(line.data(), line.size());
  }
  run_board(data, size);
  run_host(data, size);
  return 0;
}
