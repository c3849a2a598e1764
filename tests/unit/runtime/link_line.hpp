// Both ends of eagerx/link on a line in memory that does what lines do, with a clock of its own.
#pragma once

#include <algorithm>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <eagerx/link/board.hpp>
#include <eagerx/link/host.hpp>
#include <memory>
#include <mutex>
#include <random>
#include <utility>
#include <vector>

namespace eagerx::link {

using Bytes = std::vector<std::uint8_t>;

/// How bad the line is, in percent of frames.
struct Faults {
  unsigned drop = 0, duplicate = 0, corrupt = 0, reorder = 0, delay = 0;
};

/// One direction. Zeros separate frames, as a proxy would.
class Wire {
 public:
  Faults faults;
  std::mt19937 random{1};
  std::size_t hostile = 0;  // frames of somebody else before each
  bool to_board = false;
  std::size_t hostile_frames = 0;  // so far

  void put(std::uint8_t byte) { frame_.push_back(byte); }
  void flush() {
    Bytes frame;
    frame.swap(frame_);
    for (std::size_t i = 0; i < hostile; ++i) add_hostile();
    if (hostile > 0) earlier_.push_back(frame);
    if (hit(faults.drop)) return;
    if (hit(faults.corrupt)) {
      frame[random() % frame.size()] ^= static_cast<std::uint8_t>(1U << random() % 8);
    }
    if (hit(faults.delay)) {
      late_.push_back(frame);
      return;
    }
    if (hit(faults.reorder) && !line_.empty()) {
      line_.insert(line_.begin(), frame.begin(), frame.end());
    } else {
      line_.insert(line_.end(), frame.begin(), frame.end());
    }
    if (hit(faults.duplicate)) line_.insert(line_.end(), frame.begin(), frame.end());
    if (!late_.empty() && hit(50)) {
      line_.insert(line_.end(), late_.front().begin(), late_.front().end());
      late_.pop_front();
    }
  }
  int get() {
    if (line_.empty()) return kNothing;
    const int byte = line_.front();
    line_.pop_front();
    return byte;
  }
  bool empty() const { return line_.empty(); }

 private:
  bool hit(unsigned percent) { return random() % 100 < percent; }

  void add(const Bytes& bytes) { line_.insert(line_.end(), bytes.begin(), bytes.end()); }

  /// Bytes from a sender that does not know the session: noise, frames of every kind and size with
  /// a check of their own, frames that were sent before, greetings that are none.
  void add_hostile() {
    ++hostile_frames;
    Bytes noise(random() % 300);
    for (auto& byte : noise) byte = static_cast<std::uint8_t>(random());
    switch (random() % 6) {
      case 0:
        noise.push_back(0);
        add(noise);
        return;
      case 1:
        add(Bytes(random() % 20, 0));
        return;
      case 2:  // without an end: the next frame begins with one
        for (auto& byte : noise) byte |= 1U;
        add(noise);
        return;
      case 3:
        if (!earlier_.empty()) add(earlier_[random() % earlier_.size()]);
        return;
      default:
        add_sealed(noise);
    }
  }

  void add_sealed(const Bytes& payload) {
    auto frame = std::make_unique<OutFrame<300>>();
    if (!payload.empty()) frame->append(payload.data(), payload.size());
    const auto kind = static_cast<Kind>(random() % 8);
    // A greeting of the right size is one of a new host: that begins a session (ANewHostStarts…).
    const bool greeting = to_board && kind == Kind::hello && payload.size() == Greeting::kBytes;
    const bool of_no_session = random() % 2 == 0 && !greeting;
    const auto any = [this] { return static_cast<std::uint32_t>(random()); };
    frame->seal(kind, any() % 4 == 0 ? any() : any() % 1000, of_no_session ? 0 : any());
    frame->send([this](std::uint8_t byte) { line_.push_back(byte); });
  }

  std::vector<Bytes> earlier_;
  Bytes frame_;
  std::deque<std::uint8_t> line_;
  std::deque<Bytes> late_;
};

/// Host and board take turns on two threads, one at a time: the board runs while the host waits.
struct Turns {
  std::mutex mutex;
  std::condition_variable changed;
  bool board = true;  // until its thread has come to its first turn
  bool over = false;

  /// The host lets the board run until it has nothing left to read.
  void run_board() {
    std::unique_lock lock(mutex);
    board = true;
    changed.notify_all();
    changed.wait(lock, [this] { return !board || over; });
  }
  void wait_for_board() {
    std::unique_lock lock(mutex);
    changed.wait(lock, [this] { return !board; });
  }
  /// False: the test is over.
  bool wait_for_turn() {
    std::unique_lock lock(mutex);
    board = false;
    changed.notify_all();
    changed.wait(lock, [this] { return board || over; });
    return !over;
  }
  void end() {
    const std::lock_guard lock(mutex);
    over = true;
    changed.notify_all();
  }
};

struct BoardPort {
  Wire* in = nullptr;
  Wire* out = nullptr;
  Turns* turns = nullptr;

  void put(std::uint8_t byte) const { out->put(byte); }
  void flush() const { out->flush(); }
  int get() const {
    while (in->empty()) {
      if (!turns->wait_for_turn()) return kClosed;
    }
    return in->get();
  }
};

struct HostPort {
  Wire* in = nullptr;
  Wire* out = nullptr;
  Turns* turns = nullptr;
  std::uint64_t now = 0;
  bool unplugged = false;

  void put(std::uint8_t byte) const { out->put(byte); }
  void flush() const { out->flush(); }
  std::uint64_t now_ns() const { return now; }
  int get(std::uint64_t until_ns) {
    if (unplugged) return kClosed;
    if (in->empty() && !out->empty()) turns->run_board();
    if (!in->empty()) return in->get();
    now = until_ns;
    return kNothing;
  }
};

inline constexpr Identity kIdentity{0x1234, 1};

}  // namespace eagerx::link
