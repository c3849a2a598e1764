// eagerx/link: what is sent on a line is found again, and what is damaged on the way is dropped.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <eagerx/link/frame.hpp>
#include <memory>
#include <random>
#include <vector>

namespace eagerx::link {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes encoded(const Bytes& bytes) {
  Bytes result;
  cobs_encode(bytes.data(), bytes.size(), [&](std::uint8_t byte) { result.push_back(byte); });
  return result;
}

TEST(Crc32c, IsTheOneOfIscsi) {
  const Bytes digits = {'1', '2', '3', '4', '5', '6', '7', '8', '9'};
  EXPECT_EQ(crc32c(digits.data(), digits.size()), 0xe3069283U);
  EXPECT_EQ(crc32c(Bytes(32, 0).data(), 32), 0x8a9136aaU);  // RFC 3720, B.4
  EXPECT_EQ(crc32c(Bytes(32, 0xff).data(), 32), 0x62a8ab43U);
  EXPECT_EQ(crc32c(digits.data() + 4, 5, crc32c(digits.data(), 4)), 0xe3069283U);
}

TEST(Cobs, ExamplesOfThePaper) {
  EXPECT_EQ(encoded({}), (Bytes{1}));
  EXPECT_EQ(encoded({0}), (Bytes{1, 1}));
  EXPECT_EQ(encoded({0x11, 0x22, 0, 0x33}), (Bytes{3, 0x11, 0x22, 2, 0x33}));
  EXPECT_EQ(encoded(Bytes(254, 1)).size(), 255U);
  EXPECT_EQ(encoded(Bytes(255, 1)).size(), 257U);
}

TEST(Cobs, DecodesWhatItEncodes) {
  std::mt19937 random(1);
  for (std::size_t size = 0; size < 800; ++size) {
    Bytes bytes(size);
    // Few zeros, so that runs are long.
    for (auto& byte : bytes) byte = random() % 300 == 0 ? 0 : static_cast<std::uint8_t>(random());
    Bytes line = encoded(bytes);
    EXPECT_LE(line.size(), cobs_bound(size));
    for (const std::uint8_t byte : line) ASSERT_NE(byte, 0);
    line.resize(cobs_decode(line.data(), line.size()));
    ASSERT_EQ(line, bytes);
  }
}

TEST(Cobs, RefusesARunBeyondTheEnd) {
  Bytes line = {5, 1, 2};
  EXPECT_EQ(cobs_decode(line.data(), line.size()), line.size());
}

using Out = OutFrame<32>;
using In = InFrame<32>;

Bytes line_of(const Bytes& payload, std::uint32_t number = 7) {
  auto frame = std::make_unique<Out>();
  EXPECT_EQ(frame->append(payload.data(), payload.size()), payload.size());
  frame->seal(Kind::request, number, 1);
  Bytes line;
  frame->send([&](std::uint8_t byte) { line.push_back(byte); });
  return line;
}
int frames_in(In& in, const Bytes& line) {
  int frames = 0;
  for (const std::uint8_t byte : line) frames += in.take(byte) && in.intact(1) ? 1 : 0;
  return frames;
}

TEST(Frame, ComesThroughNoise) {
  auto in = std::make_unique<In>();
  const Bytes payload = {1, 0, 2, 0, 0, 255};
  Bytes line = {9, 8, 7, 200};
  const Bytes frame = line_of(payload);
  line.insert(line.end(), frame.begin(), frame.end());
  EXPECT_EQ(frames_in(*in, line), 1);
  EXPECT_EQ(in->number(), 7U);
  EXPECT_EQ(Bytes(in->payload(), in->payload() + in->size()), payload);
  EXPECT_EQ(frame.size(), payload.size() + kFrameBytes);
}

TEST(Frame, NoSingleOrDoubleBitErrorPasses) {
  const Bytes line = line_of({1, 2, 3, 4, 5, 6, 7, 8});
  const std::size_t bits = line.size() * 8;
  auto in = std::make_unique<In>();
  for (std::size_t a = 0; a < bits; ++a) {
    for (std::size_t b = a; b < bits; ++b) {
      Bytes damaged = line;
      damaged[a / 8] ^= static_cast<std::uint8_t>(1U << a % 8);
      if (a != b) damaged[b / 8] ^= static_cast<std::uint8_t>(1U << b % 8);
      damaged.push_back(0);
      // The zeros around a frame may be damaged without harm to it.
      const bool inside = !std::equal(line.begin() + 1, line.end() - 1, damaged.begin() + 1);
      const int found = frames_in(*in, damaged);
      ASSERT_TRUE(!inside || found == 0) << a << " " << b;
    }
  }
}

TEST(Frame, LongerThanItsBufferIsDropped) {
  auto in = std::make_unique<In>();
  Bytes line(500, 3);
  line.push_back(0);
  EXPECT_EQ(frames_in(*in, line), 0);
  EXPECT_EQ(in->damaged(), 1U);
  EXPECT_EQ(frames_in(*in, line_of(Bytes(32, 9))), 1);
}

}  // namespace
}  // namespace eagerx::link
