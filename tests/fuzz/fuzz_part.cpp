// Whatever comes in to a part in C: frames in the open, and greetings and records of a line with a
// key.
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <eagerx/link/frame.hpp>
#include <runtime/host/key/session.hpp>
#include <string>
#include <tests/fuzz/send_records.hpp>
#include <vector>

extern "C" {
#include <targets/c/eagerx_line.h>
#include <targets/c/eagerx_part.h>
}

namespace {

using namespace eagerx;
using fuzz::Line;

// --- a part: `mean` of what comes, and whether it is positive ---
constexpr std::uint32_t kToPart = 32, kToHub = 24, kWindow = 3;
constexpr std::uint64_t kHash = 0x0123456789abcdefU;
constexpr std::uint16_t kRuntime = 2;

std::uint8_t sensor_ring[4 * 8], flag_ring[2 * 5], mean_ring[4];
eagerx_message messages[] = {{sensor_ring, 8, 4, 0}, {flag_ring, 5, 2, 1}, {mean_ring, 4, 1, 0}};
float sensor_window[kWindow][2];
std::uint8_t flag_window[2][5];
eagerx_input sensor_input = {&messages[0], sensor_window, kWindow, 0, 1, 1, 0, 0, 0};
eagerx_input flag_input = {&messages[1], flag_window, 0, 1, 1, 2, 1, 0, 0};

void run_node(std::uint64_t n) {
  const std::uint32_t sensors = eagerx_take(&sensor_input, n);
  const std::uint32_t flags = eagerx_take(&flag_input, n);
  if (sensors == 0 || sensors > kWindow || flags > 2) std::abort();
  float sum = 0;
  for (std::uint32_t i = 0; i < sensors; ++i) sum += sensor_window[i][0];
  for (std::uint32_t i = 0; i < flags; ++i)
    for (const std::uint8_t flag : flag_window[i])
      if (flag > 1) std::abort();  // a bool is 0 or 1
  eagerx_put(&messages[2], n, &sum);
}

void reset_nodes() {
  sensor_input.received = flag_input.received = 0;
}

constexpr std::uint32_t kSensor[] = {0}, kFlag[] = {1}, kMean[] = {2};
constexpr eagerx_turn kBefore[] = {
    {0, nullptr, kSensor, 1}, {1, nullptr, kFlag, 1}, {0, run_node, kMean, 1}};
constexpr eagerx_turn kAfter[] = {{0, nullptr, nullptr, 0}};
constexpr std::uint64_t kPeriods[] = {1, 2};
constexpr eagerx_part kPart = {"part",   "fuzz", kHash,  kRuntime, kToPart,    kToHub,  3,
                               kPeriods, 2,      1,      1,        messages,   kSensor, 1,
                               kBefore,  3,      kAfter, 0,        reset_nodes};

// --- the line: what the data are, and no listener ---
const std::uint8_t *at = nullptr, *end = nullptr;
Line answered;

}  // namespace

extern "C" {
std::size_t eagerx_line_read(std::uint8_t* bytes, std::size_t size) {
  const std::size_t count = std::min(size, static_cast<std::size_t>(end - at));
  if (count > 0) std::memcpy(bytes, at, count);
  at += count;
  return count;
}
int eagerx_line_write(const std::uint8_t* bytes, std::size_t size) {
  answered.insert(answered.end(), bytes, bytes + size);
  return answered.size() < (std::size_t{1} << 22U) ? 1 : 0;
}
int eagerx_line_knows_peer(void) {
  return 0;
}
}

namespace {

/// A part answers in frames, which the hub in C++ reads.
void check_answers() {
  std::size_t begin = 0;
  while (begin < answered.size()) {
    if (answered[begin++] != 0) std::abort();
    const auto zero =
        std::find(answered.begin() + static_cast<std::ptrdiff_t>(begin), answered.end(), 0);
    if (zero == answered.end()) std::abort();
    const auto next = static_cast<std::size_t>(zero - answered.begin());
    Line frame(answered.begin() + static_cast<std::ptrdiff_t>(begin), zero);
    const std::size_t size = link::cobs_decode(frame.data(), frame.size());
    constexpr std::size_t kAround = link::kHeaderBytes + link::kCrcBytes;
    if (size < kAround || size > std::max<std::size_t>(kToHub, link::Greeting::kBytes) + kAround)
      std::abort();
    begin = next + 1;
  }
}

void run_part(const Line& line) {
  at = line.data();
  end = at + line.size();
  answered.clear();
  eagerx_run(&kPart);
  check_answers();
}

void append_frame(Line& line, link::Kind kind, std::uint32_t number, const std::uint8_t* bytes,
                  std::size_t size, std::uint32_t crc_start) {
  link::OutFrame<kToPart> frame{};
  frame.append(bytes, std::min<std::size_t>(size, kToPart));
  frame.seal(kind, number, crc_start);
  frame.send([&](std::uint8_t byte) { line.push_back(byte); });
}

/// A session whose frames are whole; what is in them, in which order and between them are the data.
Line session_of(const std::uint8_t* data, std::size_t size) {
  link::Greeting greeting;
  greeting.runtime = kRuntime;
  greeting.graph = kHash;
  greeting.session = 1;
  std::uint8_t bytes[link::Greeting::kBytes];
  greeting.write(bytes);
  Line line;
  append_frame(line, link::Kind::hello, 0, bytes, sizeof bytes, 0);
  std::uint32_t number = 0;
  for (std::size_t i = 0; i + 2 <= size;) {
    const std::uint8_t what = data[i], length = data[i + 1];
    i += 2;
    const std::size_t count = std::min<std::size_t>(length, size - i);
    if (what < 160) {  // as it should be
      append_frame(line, link::Kind::request, ++number, data + i, count, greeting.crc_start());
    } else if (what < 200) {  // again, or another one
      append_frame(line, link::Kind::request, number - what % 5U, data + i, count,
                   greeting.crc_start());
    } else if (what < 210) {  // a session anew
      greeting.session = what;
      greeting.write(bytes);
      append_frame(line, link::Kind::hello, 0, bytes, sizeof bytes, 0);
      number = 0;
    } else {
      line.insert(line.end(), data + i, data + i + count);
    }
    i += std::min<std::size_t>(count, what < 210 ? kToPart : 255);
  }
  return line;
}

// --- a line with a key ---
const key::Functions& functions() {
  static std::string problem;
  static const key::Functions* const found = key::sodium(problem);
  if (found == nullptr) std::abort();
  return *found;
}

eagerx_key key_in_c() {
  static eagerx_key found = [] {
    char path[] = "/tmp/eagerx-fuzz-XXXXXX";
    const int file = mkstemp(path);  // mode 0600
    const std::string text = "eagerx-gen key 1 " + std::string(64, '1') + "\n";
    char problem[EAGERX_PROBLEM];
    eagerx_key key;
    if (file < 0 || write(file, text.data(), text.size()) != static_cast<ssize_t>(text.size()) ||
        eagerx_key_use(path, &key, problem, sizeof problem) == 0)
      std::abort();
    unlink(path);
    close(file);
    return key;
  }();
  return found;
}

key::Key key_in_cpp() {
  key::Key key;
  key.fill(0x11);
  return key;
}

/// No peer without the key is let in, whatever it sends and in whatever pieces.
void greet_stranger(const Line& said) {
  const eagerx_key key = key_in_c();
  eagerx_greeting greeting;
  eagerx_greeting_begin(&greeting, &key);
  std::uint8_t answer[EAGERX_ANSWER];
  for (std::size_t i = 0; i < said.size();) {
    const std::size_t piece = std::min<std::size_t>(said[i] % 64U + 1U, said.size() - i);
    const std::size_t taken = std::min(piece, eagerx_greeting_wanted(&greeting));
    if (taken == 0 || eagerx_greeting_take(&greeting, said.data() + i, taken, answer) < 0) break;
    i += taken;
  }
  if (greeting.is_done != 0) std::abort();
}

struct Session {
  key::Records hub;
  eagerx_records part;
  Session() {
    key::Greeting connector;
    eagerx_greeting listener;
    const eagerx_key key = key_in_c();
    std::uint8_t answer[EAGERX_ANSWER];
    connector.begin(functions(), key_in_cpp(), key::Role::connects);
    eagerx_greeting_begin(&listener, &key);
    const auto hear = [&] {
      const key::Bytes bytes = connector.to_send();
      const int size = eagerx_greeting_take(&listener, bytes.data(), bytes.size(), answer);
      connector.sent();
      return size;
    };
    if (hear() != EAGERX_ANSWER || !connector.take({answer, sizeof answer}) || hear() != 0 ||
        listener.is_done == 0)
      std::abort();
    connector.go_on(hub);
    eagerx_greeting_go_on(&listener, &part);
  }
};

/// Opens all that comes; how many records of `text` it was. Anything else is a forgery that passed.
int open_all(eagerx_records& by, const Line& line, const Line& text) {
  std::vector<std::uint8_t> bytes(EAGERX_RECORD);
  int opened = 0;
  for (std::size_t i = 0; i < line.size();) {
    const std::size_t count = std::min(sizeof by.taken - by.taken_size, line.size() - i);
    std::copy_n(line.begin() + static_cast<std::ptrdiff_t>(i), count, by.taken + by.taken_size);
    by.taken_size += count;
    i += count;
    for (;;) {
      std::size_t size = 0;
      const eagerx_found found = eagerx_open(&by, bytes.data(), &size);
      if (found == EAGERX_NOTHING) break;
      if (found == EAGERX_END || (found == EAGERX_FORGED && size != 0)) std::abort();
      if (found == EAGERX_FORGED) return opened;
      if (size != text.size() || !std::equal(text.begin(), text.end(), bytes.begin())) std::abort();
      ++opened;
    }
  }
  return opened;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  run_part(Line(data, data + size));
  run_part(session_of(data, size));
  greet_stranger(Line(data, data + size));
  Line titled(key::Greeting::kTitle.begin(), key::Greeting::kTitle.end());
  titled.insert(titled.end(), data, data + size);
  greet_stranger(titled);
  fuzz::send_records<Session>(data, size, EAGERX_RECORD, open_all);
  return 0;
}
