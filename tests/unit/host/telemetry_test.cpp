// A board's ring and sender against the decoder: what is sent comes out, and nothing else.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <eagerx/link/telemetry.hpp>
#include <map>
#include <memory>
#include <random>
#include <runtime/host/telemetry/decoder.hpp>
#include <string>
#include <vector>

namespace eagerx::telemetry {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Values = std::array<float, 3>;

/// Channel 0: float32 [3], every second message; 1: bool, with it; 2: not sent; 3: int64.
struct Sent {
  static constexpr std::uint64_t kGraph = 0x0123456789abcdefU;
  static constexpr std::size_t kCells = 8;
  static constexpr std::uint32_t kGreetEvery = 10;
  static constexpr link::TelemetryGroup kGroups[] = {{24, 0x3, 2}, {16, 0x1, 1}};
  static constexpr link::TelemetryPlace kPlaces[] = {{0, 0, 8}, {0, 1, 20}, {}, {1, 0, 8}};
};

Layout layout_of_sent() {
  Layout layout{"sent", Sent::kGraph, kVersionMajor * 256 + kVersionMinor, 115'200, {}};
  layout.groups.push_back({1000,
                           1,
                           2,
                           24,
                           {{"a/x", "a.x", trace_log::Dtype::float32, {3}, 3, 8},
                            {"a/on", "a.on", trace_log::Dtype::boolean, {}, 1, 20}}});
  layout.groups.push_back({100, 1, 1, 16, {{"b/n", "b.n", trace_log::Dtype::int64, {}, 1, 8}}});
  return layout;
}

using Board = link::Telemetry<Sent>;

std::unique_ptr<Board> board() {
  auto board = std::make_unique<Board>();  // zero, as in .bss
  board->start();
  board->episode(0);
  return board;
}
/// All that the line takes.
void send(Board& board, Bytes& line) {
  while (board.step([&](std::uint8_t byte) { return line.push_back(byte), true; })) {
  }
}
Values values_of(std::uint64_t seq) {
  return {static_cast<float>(seq), -static_cast<float>(seq), 0.5F};
}
void slot(Board& board, std::uint64_t seq) {
  board.take(0, seq, values_of(seq));
  board.take(2, seq, 1.0F);
  board.take(1, seq, seq % 4 == 0);
  if (seq % 10 == 0) board.take(3, seq / 10, static_cast<std::int64_t>(seq) - 5);
}
Bytes line_of(std::uint64_t slots) {
  const auto sender = board();
  Bytes line;
  for (std::uint64_t seq = 0; seq < slots; ++seq) {
    slot(*sender, seq);
    send(*sender, line);
  }
  return line;
}

/// Every message by channel and number; a value that was not sent is a failure.
struct Checking : Listener {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint64_t>> seqs;
  std::uint32_t episode = 0;
  std::string said;

  void message(const Message& message) override {
    seqs[{message.group, message.channel}].push_back(message.seq);
    EXPECT_EQ(message.episode, episode);
    if (message.group == 1) {
      EXPECT_EQ(message.values[0], message.seq * 10 - 5);
    } else if (message.channel == 1) {
      EXPECT_EQ(message.values[0], message.seq % 4 == 0 ? 1U : 0U);
    } else {
      const Values values = values_of(message.seq);
      for (std::size_t i = 0; i < values.size(); ++i)
        EXPECT_EQ(message.values[i], canonical_bits(values[i]));
    }
  }
  void text(std::string_view text) override { said += text; }
};
Counts decode(const Bytes& line, Checking& checking, std::string* refusal = nullptr,
              const Layout& layout = layout_of_sent()) {
  const auto decoder = std::make_unique<Decoder>(layout);
  decoder->take(line.data(), line.size(), checking);
  if (refusal != nullptr) *refusal = decoder->refusal();
  return decoder->counts();
}

TEST(Telemetry, WhatIsSentComesOut) {
  ASSERT_EQ(problem_with(layout_of_sent()), "");
  Checking checking;
  const Counts counts = decode(line_of(1000), checking);
  EXPECT_EQ(counts.records, 600U);
  EXPECT_EQ(counts.greetings, 61U);  // before the first record, and after every tenth
  EXPECT_EQ(counts.damaged + counts.lost + counts.unknown + counts.dropped, 0U);
  std::vector<std::uint64_t> even, all;
  for (std::uint64_t i = 0; i < 500; ++i) even.push_back(2 * i);
  for (std::uint64_t i = 0; i < 100; ++i) all.push_back(i);
  EXPECT_EQ((checking.seqs[{0, 0}]), even);
  EXPECT_EQ((checking.seqs[{0, 1}]), even);
  EXPECT_EQ((checking.seqs[{1, 0}]), all);
}

TEST(Telemetry, NothingLeavesBeforeItStarts) {
  const auto off = std::make_unique<Board>();
  Bytes line;
  slot(*off, 0);
  send(*off, line);
  EXPECT_TRUE(line.empty());
  EXPECT_EQ(off->records(), 0U);
}

TEST(Telemetry, AFullRingDropsAndCounts) {
  const auto sender = board();
  Bytes line;
  // Nothing can be sent for 40 slots: 20 and 4 records, of which 8 have room.
  for (std::uint64_t seq = 0; seq < 40; ++seq) {
    slot(*sender, seq);
    for (int i = 0; i < 100; ++i) sender->step([](std::uint8_t) { return false; });
  }
  EXPECT_EQ(sender->records(), 24U);
  EXPECT_EQ(sender->dropped(), 16U);
  send(*sender, line);
  // Afterwards it continues as before.
  for (std::uint64_t seq = 40; seq < 200; ++seq) {
    slot(*sender, seq);
    send(*sender, line);
  }
  EXPECT_EQ(sender->dropped(), 16U);
  Checking checking;
  const Counts counts = decode(line, checking);
  EXPECT_EQ(counts.lost, 16U);
  EXPECT_EQ(counts.dropped, 16U);
  EXPECT_EQ(counts.damaged, 0U);
  EXPECT_EQ((checking.seqs[{0, 0}].back()), 198U);
}

TEST(Telemetry, AThousandDamagedFramesAreCountedAndNothingWrongIsShown) {
  const Bytes line = line_of(4000);
  std::mt19937 random(1);
  Bytes damaged;
  std::uint64_t frames = 0, broken = 0;
  // Frame by frame: a zero begins and a zero ends each.
  for (auto at = line.begin(); at != line.end();) {
    const auto end = std::find(at + 1, line.end(), std::uint8_t{0}) + 1;
    Bytes frame(at, end);
    at = end;
    ++frames;
    if (frames > 1 && broken < 1000 && random() % 2 == 0) {
      ++broken;
      const std::size_t place = 1 + random() % (frame.size() - 2);
      switch (random() % 3) {
        case 0: {
          const auto bit = static_cast<std::uint8_t>(1U << random() % 8);
          // No zero, which would make two pieces of it.
          frame[place] = frame[place] == bit ? frame[place] + 1 : frame[place] ^ bit;
          break;
        }
        case 1:
          frame.erase(frame.begin() + static_cast<std::ptrdiff_t>(place));
          break;
        default:
          frame.insert(frame.begin() + static_cast<std::ptrdiff_t>(place), 0x55);
      }
    }
    damaged.insert(damaged.end(), frame.begin(), frame.end());
  }
  ASSERT_EQ(broken, 1000U);
  Checking checking;
  const Counts counts = decode(damaged, checking);
  EXPECT_EQ(counts.damaged, 1000U);
  EXPECT_EQ(counts.records + counts.greetings + counts.damaged, frames);
  // All of those that are missing before the last record that came.
  EXPECT_GE(counts.lost, 900U);
  EXPECT_LE(counts.lost, 1000U);
}

TEST(Telemetry, NoiseIsSurvivedAndCostsNoMemory) {
  std::mt19937 random(2);
  Bytes line(1'000'000);
  for (auto& byte : line) byte = static_cast<std::uint8_t>(random());
  const Bytes frames = line_of(20);
  line.push_back(0);
  line.insert(line.end(), frames.begin(), frames.end());
  line.insert(line.end(), 100'000, 0x41);
  line.push_back(0);
  line.insert(line.end(), frames.begin() + 1, frames.end());
  Checking checking;
  const Counts counts = decode(line, checking);
  EXPECT_EQ(counts.records, 24U);
  EXPECT_GE(counts.damaged, 1000U);
}

TEST(Telemetry, OneOfAnotherGraphIsRefusedWithTheReason) {
  Layout other = layout_of_sent();
  other.graph = "other";
  other.hash = 1;
  Checking checking;
  std::string refusal;
  const Counts counts = decode(line_of(100), checking, &refusal, other);
  EXPECT_EQ(refusal,
            "the board runs another graph, or the same of another time: its hash is "
            "0x0123456789abcdef, that of `other` is 0x0000000000000001");
  EXPECT_TRUE(checking.seqs.empty());
  EXPECT_EQ(counts.records, 0U);
}

TEST(Telemetry, WhoComesLaterWaitsForAGreeting) {
  const Bytes line = line_of(200);
  const Bytes rest(line.begin() + 100, line.end());
  Checking checking;
  const Counts counts = decode(rest, checking);
  EXPECT_GE(counts.unknown, 1U);
  EXPECT_EQ(counts.lost, 0U);
  EXPECT_GE(counts.records, 90U);
}

TEST(Telemetry, TextBetweenFramesIsText) {
  const Bytes frames = line_of(10);
  const std::string text = "steps 10\ntrace hash 0x1\n";
  Bytes line = frames;
  line.insert(line.end(), text.begin(), text.end());
  line.push_back(0);
  Checking checking;
  const Counts counts = decode(line, checking);
  EXPECT_EQ(checking.said, text);
  EXPECT_EQ(counts.text, text.size());
  EXPECT_EQ(counts.damaged, 0U);
}

TEST(Telemetry, EpisodesBeginAnew) {
  const auto sender = board();
  Bytes line;
  Checking checking;
  const Layout layout = layout_of_sent();
  const auto decoder = std::make_unique<Decoder>(layout);
  for (std::uint32_t episode = 0; episode < 600; ++episode) {
    sender->episode(episode);
    checking.episode = episode;
    line.clear();
    for (std::uint64_t seq = 0; seq < 7; ++seq) {
      slot(*sender, seq);
      send(*sender, line);
    }
    decoder->take(line.data(), line.size(), checking);
  }
  EXPECT_EQ((checking.seqs[{0, 0}].size()), 600U * 4);
  EXPECT_EQ((checking.seqs[{0, 0}].back()), 6U);
  EXPECT_EQ(decoder->counts().lost, 0U);
}

TEST(Telemetry, WhatOnlySomeChannelsSendIsSentWithAMask) {
  const auto sender = board();
  Bytes line;
  for (std::uint64_t seq = 0; seq < 20; ++seq) {
    sender->take(0, seq, values_of(seq));  // and never the other one of its group
    send(*sender, line);
  }
  sender->end_run();
  send(*sender, line);
  Checking checking;
  const Counts counts = decode(line, checking);
  EXPECT_EQ(counts.records, 10U);
  EXPECT_EQ((checking.seqs[{0, 0}].size()), 10U);
  EXPECT_EQ((checking.seqs[{0, 1}].size()), 0U);
}

/// Which messages of the first channel come out.
std::vector<std::uint64_t> seqs_of(const Bytes& line) {
  struct Seen : Listener {
    std::vector<std::uint64_t> seqs;
    void message(const Message& message) override {
      if (message.group == 0 && message.channel == 0) seqs.push_back(message.seq);
    }
  } seen;
  const Layout layout = layout_of_sent();
  const auto decoder = std::make_unique<Decoder>(layout);
  decoder->take(line.data(), line.size(), seen);
  EXPECT_EQ(decoder->counts().lost, 0U);
  return seen.seqs;
}

TEST(Telemetry, AResetRoutineGoesOnFromTheEpisodeBeforeAndNumbersBeginAnew) {
  const auto sender = board();
  Bytes line;
  const auto slots = [&](std::uint64_t from, std::uint64_t to) {
    for (std::uint64_t seq = from; seq < to; ++seq) {
      slot(*sender, seq);
      send(*sender, line);
    }
  };
  slots(0, 1);
  slots(0, 5);  // the first episode: set, then the routine, then it begins
  sender->episode(1);
  slots(5, 8);
  slots(0, 3);
  sender->end_run();
  send(*sender, line);
  EXPECT_EQ(seqs_of(line), (std::vector<std::uint64_t>{0, 0, 2, 4, 6, 0, 2}));
}

TEST(Telemetry, NumbersThatBeginAnewWithinARecord) {
  const auto sender = board();
  Bytes line;
  sender->take(0, 0, values_of(0));  // and the action never comes
  sender->take(0, 0, values_of(0));
  sender->take(1, 0, true);
  send(*sender, line);
  EXPECT_EQ(seqs_of(line), (std::vector<std::uint64_t>{0, 0}));
}

TEST(Telemetry, NumbersBeyond32Bits) {
  const auto sender = board();
  Bytes line;
  const Layout layout = layout_of_sent();
  const auto decoder = std::make_unique<Decoder>(layout);
  std::vector<std::uint64_t> seen;
  struct Seen : Listener {
    std::vector<std::uint64_t>& seqs;
    explicit Seen(std::vector<std::uint64_t>& into) : seqs(into) {}
    void message(const Message& message) override { seqs.push_back(message.seq); }
  } listener(seen);
  for (const std::uint64_t seq : {std::uint64_t{0}, std::uint64_t{0x70000000U},
                                  std::uint64_t{0xe0000000U}, std::uint64_t{0x140000000U}}) {
    sender->take(3, seq, std::int64_t{0});
    send(*sender, line);
  }
  decoder->take(line.data(), line.size(), listener);
  EXPECT_EQ(seen, (std::vector<std::uint64_t>{0, 0x70000000U, 0xe0000000U, 0x140000000U}));
}

TEST(Telemetry, ALineWithoutRoomIsNeverWaitedFor) {
  const auto sender = board();
  slot(*sender, 0);
  // However often it is asked: it offers the same byte and returns.
  std::uint8_t offered = 0xff;
  for (int i = 0; i < 1000; ++i)
    EXPECT_TRUE(sender->step([&](std::uint8_t byte) { return offered = byte, false; }));
  EXPECT_EQ(offered, 0);
  Bytes line;
  send(*sender, line);
  Checking checking;
  EXPECT_EQ(decode(line, checking).records, 2U);
}

TEST(Telemetry, LayoutsThatDoNotFit) {
  const auto problem = [](auto change) {
    Layout layout = layout_of_sent();
    change(layout);
    return problem_with(layout);
  };
  EXPECT_NE(problem([](Layout& layout) { layout.groups.clear(); }), "");
  EXPECT_NE(problem([](Layout& layout) { layout.groups[0].bytes = 4; }), "");
  EXPECT_NE(problem([](Layout& layout) { layout.groups[0].bytes = 1'000'000; }), "");
  EXPECT_NE(problem([](Layout& layout) { layout.groups[0].channels[0].offset = 13; }), "");
  EXPECT_NE(problem([](Layout& layout) { layout.groups[0].channels[0].offset = SIZE_MAX; }), "");
  EXPECT_NE(problem([](Layout& layout) {
              layout.groups[0].channels[0].shape = {1ULL << 63U, 2};
            }),
            "");
  EXPECT_NE(problem([](Layout& layout) { layout.groups[0].channels.resize(17); }), "");
  EXPECT_NE(problem([](Layout& layout) { layout.groups[0].every = 0; }), "");
}

}  // namespace
}  // namespace eagerx::telemetry
