// eagerx/link: frames survive a line that does not; what does not come through ends a run with its
// reason and never as a number.
#include <gtest/gtest.h>

#include <algorithm>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <eagerx/link/board.hpp>
#include <eagerx/link/host.hpp>
#include <memory>
#include <mutex>
#include <random>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace eagerx::link {
namespace {

using Bytes = std::vector<std::uint8_t>;

// --- both ends, on a line in memory with a clock of its own ---

/// How bad the line is, in percent of frames.
struct Faults {
  unsigned drop = 0, duplicate = 0, corrupt = 0, reorder = 0, delay = 0;
};

/// One direction. Frames are told apart by the zeros, as a proxy would.
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

  /// What somebody may send who does not know the session: noise, frames of every kind and size
  /// with a check of their own, frames that were sent before, greetings that are none.
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

constexpr std::size_t kToBoard = 24;
constexpr std::size_t kToHost = 16;

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

using HostEnd = HostLink<HostPort, kToBoard, kToHost>;
using BoardEnd = BoardLink<BoardPort, kToBoard, kToHost>;
constexpr Identity kIdentity{0x1234, 1};

class Line : public ::testing::Test {
 protected:
  void start(Identity identity = kIdentity, std::uint8_t status = 0) {
    board_->port.in = &to_board_;
    board_->port.out = &to_host_;
    board_->port.turns = &turns_;
    board_->identify(identity, status);
    host_->port.in = &to_host_;
    host_->port.out = &to_board_;
    host_->port.turns = &turns_;
    thread_ = std::thread([this] {
      if (turns_.wait_for_turn()) run_board();
    });
    turns_.wait_for_board();
  }
  void TearDown() override {
    turns_.end();
    if (thread_.joinable()) thread_.join();
  }
  void set_faults(const Faults& faults, unsigned seed) {
    to_board_.faults = to_host_.faults = faults;
    to_board_.random.seed(seed);
    to_host_.random.seed(seed + 1000);
  }

  /// What a board does: commands, then messages.
  void run_board() {
    while (board_->wait_for_host()) {
      ++sessions_;
      std::uint32_t sum = 0;
      std::uint8_t command = 0;
      while (board_->get(command)) {
        if (command == static_cast<std::uint8_t>(Command::step)) {
          std::uint8_t late = 0;
          if (!board_->get(late)) break;
          Array<std::uint32_t, 20> values{};  // longer than a frame
          bool flag = false;
          if (!board_->get(values) || !board_->get(flag)) break;
          for (const std::uint32_t value : values) sum += value;
          board_->put(sum);
          board_->put(flag);
          board_->put(values);
        } else if (command == static_cast<std::uint8_t>(Command::reset)) {
          Episode episode;
          if (!episode.get(*board_)) break;
          sum = episode.key.episode;
        } else {
          Report{100, board_->damaged()}.put(*board_);
          put_count(*board_, "resets", 7);
          put_count(*board_, "a longer name than a frame has room for", 1ULL << 40U);
          end_counts(*board_);
        }
      }
    }
  }
  /// Steps until one fails; how many went well, and all of these were right.
  int run_host(int steps) {
    std::uint32_t sum = 5;
    host_->begin_episode({{1, 2, 5}, 0});
    for (int step = 0; step < steps; ++step) {
      Array<std::uint32_t, 20> values{};
      for (std::uint32_t i = 0; i < 20; ++i) {
        values[i] = i * static_cast<std::uint32_t>(step);
        sum += values[i];
      }
      const bool flag = step % 3 == 0;
      host_->begin_step();
      host_->put(values);
      host_->put(flag);
      std::uint32_t found = 0;
      bool flag_found = false;
      Array<std::uint32_t, 20> echo{};
      if (!host_->get(found) || !host_->get(flag_found) || !host_->get(echo)) return step;
      EXPECT_EQ(found, sum);
      EXPECT_EQ(flag_found, flag);
      EXPECT_EQ(echo, values);
    }
    return steps;
  }

  Wire to_board_, to_host_;
  Turns turns_;
  std::unique_ptr<HostEnd> host_ = std::make_unique<HostEnd>();
  std::unique_ptr<BoardEnd> board_ = std::make_unique<BoardEnd>();
  std::thread thread_;
  int sessions_ = 0;
};

TEST_F(Line, CarriesMessagesLongerThanItsFrames) {
  start();
  ASSERT_TRUE(host_->open(kIdentity, 1));
  EXPECT_EQ(run_host(50), 50);
  Report report;
  std::vector<std::pair<std::string, std::uint64_t>> counts;
  ASSERT_TRUE(host_->finish(
      report, [&](const char* name, std::uint64_t count) { counts.emplace_back(name, count); }));
  EXPECT_EQ(report.stack_bytes, 100U);
  ASSERT_EQ(counts.size(), 2U);
  EXPECT_EQ(counts[0].first, "resets");
  EXPECT_EQ(counts[0].second, 7U);
  EXPECT_EQ(counts[1].first, "a longer name than a frame has room for");
  EXPECT_EQ(counts[1].second, 1ULL << 40U);
  EXPECT_EQ(host_->statistics().repeated, 0U);
  EXPECT_EQ(host_->statistics().ignored, 0U);
}

TEST_F(Line, RepeatsUntilItIsRight) {
  start();
  for (unsigned seed = 1; seed <= 20; ++seed) {
    set_faults({20, 20, 20, 20, 20}, seed);
    host_->set_time_limit(600'000'000'000);
    ASSERT_TRUE(host_->open(kIdentity, seed)) << seed;
    EXPECT_EQ(run_host(50), 50) << seed;
    Report report;
    EXPECT_TRUE(host_->finish(report, [](const char*, std::uint64_t) {}));
  }
  EXPECT_EQ(sessions_, 20);
  EXPECT_GT(host_->statistics().repeated, 1000U);
  EXPECT_GT(host_->statistics().ignored, 1000U);
}

TEST_F(Line, TenThousandHostileFramesEachWayChangeNothing) {
  start();
  to_board_.to_board = true;
  to_host_.random.seed(2);
  ASSERT_TRUE(host_->open(kIdentity, 1));
  to_board_.hostile = to_host_.hostile = 20;
  int steps = 0;
  while (steps < 5000 && std::min(to_board_.hostile_frames, to_host_.hostile_frames) < 10'000) {
    ASSERT_EQ(run_host(10), 10) << steps;  // and all that came was right
    steps += 10;
  }
  EXPECT_GE(to_board_.hostile_frames, 10'000U);
  EXPECT_GE(to_host_.hostile_frames, 10'000U);
  EXPECT_EQ(sessions_, 1);
  EXPECT_GT(board_->damaged(), 1000U);
  to_board_.hostile = to_host_.hostile = 0;
  Report report;
  EXPECT_TRUE(host_->finish(report, [](const char*, std::uint64_t) {}));
}

TEST_F(Line, GivesUpWhenNothingComes) {
  start();
  ASSERT_TRUE(host_->open(kIdentity, 1));
  EXPECT_EQ(run_host(3), 3);
  set_faults({100, 0, 0, 0, 0}, 1);
  const std::uint64_t before = host_->port.now;
  EXPECT_EQ(run_host(3), 0);
  EXPECT_EQ(host_->problem(), Problem::no_answer);
  EXPECT_EQ(host_->port.now - before, 5'000'000'000U);
}

TEST_F(Line, TellsOnceInAnExchangeThatTheBoardIsSilent) {
  start();
  ASSERT_TRUE(host_->open(kIdentity, 1));
  int times = 0;
  host_->on_silence(
      10'000'000, [](void* context) { ++*static_cast<int*>(context); }, &times);
  EXPECT_EQ(run_host(3), 3);
  EXPECT_EQ(times, 0);
  set_faults({100, 0, 0, 0, 0}, 1);
  const std::uint64_t before = host_->port.now;
  EXPECT_EQ(run_host(3), 0);
  EXPECT_EQ(times, 1);
  EXPECT_EQ(host_->port.now - before, 5'000'000'000U) << "it waits on";
}

TEST_F(Line, TellsNobodyOfSilenceAfterTheEnd) {
  start();
  ASSERT_TRUE(host_->open(kIdentity, 1));
  int times = 0;
  host_->on_silence(
      10'000'000, [](void* context) { ++*static_cast<int*>(context); }, &times);
  EXPECT_EQ(run_host(3), 3);
  host_->on_silence(0, nullptr, nullptr);
  set_faults({100, 0, 0, 0, 0}, 1);
  Report report;
  EXPECT_FALSE(host_->finish(report, [](const char*, std::uint64_t) {}));
  EXPECT_EQ(times, 0);
}

TEST(Number, OfAnExchangeIsNeverThatOfNone) {
  EXPECT_EQ(next_number(0), 1U);
  EXPECT_EQ(next_number(UINT32_MAX), 1U);
}

TEST_F(Line, SaysWhenItIsClosed) {
  start();
  ASSERT_TRUE(host_->open(kIdentity, 1));
  EXPECT_EQ(run_host(3), 3);
  host_->port.unplugged = true;
  EXPECT_EQ(run_host(3), 0);
  EXPECT_EQ(host_->problem(), Problem::closed);
}

TEST_F(Line, ANewHostStartsTheBoardAnew) {
  start();
  ASSERT_TRUE(host_->open(kIdentity, 1));
  EXPECT_EQ(run_host(3), 3);
  host_->begin_step();  // and in the middle of a step it is gone
  ASSERT_TRUE(host_->open(kIdentity, 2));
  EXPECT_EQ(run_host(3), 3);
  EXPECT_EQ(sessions_, 2);
}

TEST_F(Line, RefusesAnotherGraph) {
  start({0x1235, 1});
  EXPECT_FALSE(host_->open(kIdentity, 1));
  EXPECT_EQ(host_->problem(), Problem::other_graph);
  EXPECT_EQ(host_->board().graph, 0x1235U);
  EXPECT_EQ(sessions_, 0);
}

TEST_F(Line, RefusesAnotherRuntime) {
  start({0x1234, 2});
  EXPECT_FALSE(host_->open(kIdentity, 1));
  EXPECT_EQ(host_->problem(), Problem::other_runtime);
}

TEST_F(Line, RefusesABoardThatDoesNotWork) {
  start(kIdentity, 1);
  EXPECT_FALSE(host_->open(kIdentity, 1));
  EXPECT_EQ(host_->problem(), Problem::refused);
  EXPECT_EQ(sessions_, 0);
}

TEST_F(Line, ALinkThatIsOverStaysSo) {
  start();
  EXPECT_EQ(run_host(3), 0);  // never opened
  EXPECT_EQ(host_->problem(), Problem::closed);
}

}  // namespace
}  // namespace eagerx::link
