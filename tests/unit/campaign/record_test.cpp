#include "targets/environments/campaign/record.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <string_view>

namespace eagerx::campaign {
namespace {

Plan plan() {
  Plan plan;
  plan.runs = kChunk + 2;
  plan.columns = {"pendulum.mass"};
  return plan;
}

std::string record() {
  Results results(2, 1);
  results.returns = {1.5, -2.0};
  results.steps = {30, 31};
  results.counts = {{"safe: action not finite: u", 3}};
  return record_of(1, results);
}

TEST(CampaignRecord, IsFoundBehindNoise) {
  const std::string bytes = "noise" + record();
  std::size_t work = 10 * bytes.size();
  ASSERT_EQ(find_record(bytes, 0, plan(), work), 5U);
  std::string_view left = std::string_view(bytes).substr(5);
  const auto taken = take_record(left, plan());
  ASSERT_TRUE(taken.has_value());
  EXPECT_EQ(taken->results.steps[1], 31U);
  EXPECT_TRUE(left.empty());
}

// Found by tests/fuzz/fuzz_journal: what was taken at its place was not found behind noise.
TEST(CampaignRecord, EndsWithItsCounts) {
  std::string bytes = record();
  std::string body = bytes.substr(12) + std::string(3, '\0');
  std::uint64_t sum = 0xcbf29ce484222325U;
  for (const char c : body) sum = (sum ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  const auto size = static_cast<std::uint32_t>(body.size());
  bytes.resize(12);
  std::memcpy(bytes.data(), &size, sizeof size);
  std::memcpy(bytes.data() + sizeof size, &sum, sizeof sum);
  bytes += body;
  std::string_view left = bytes;
  EXPECT_FALSE(take_record(left, plan()).has_value());
}

// On 0d2dc587 each of thousands of heads cost the check sum of all that follows, and the same again
// behind every record that has the right sum and nothing good in it.
TEST(CampaignRecord, BytesMadeToLookLikeManyRecordsCostNoMoreThanTheyMay) {
  constexpr std::uint32_t kHead = 16;
  constexpr std::uint32_t kHeads = 4000;
  std::string bytes;
  for (std::uint32_t i = 0; i < kHeads; ++i) {
    const std::uint32_t size = (kHeads - i) * kHead - 12;  // up to the last byte
    const std::uint32_t chunk = 0;
    std::string head(kHead, '\x7f');  // of a sum that is wrong
    std::memcpy(head.data(), &size, sizeof size);
    std::memcpy(head.data() + 12, &chunk, sizeof chunk);
    bytes += head;
  }
  bytes.back() = '}';
  std::size_t work = 4 * bytes.size();
  EXPECT_EQ(find_record(bytes, 0, plan(), work), std::string_view::npos);
  EXPECT_LT(work, bytes.size());  // used up, not all of the heads were looked at
}

}  // namespace
}  // namespace eagerx::campaign
