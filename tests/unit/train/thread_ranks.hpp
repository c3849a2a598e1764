// Ranks that are threads, for tests that need no MPI.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <barrier>
#include <cstdlib>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "targets/environments/ranks/ranks.hpp"

namespace eagerx::train {

using environments::Ranks;

using Sizes = std::span<const std::size_t>;

inline std::size_t begin_of(Sizes sizes, std::uint32_t rank) {
  return std::accumulate(sizes.begin(), sizes.begin() + rank, std::size_t{0});
}

/// Where the threads meet.
struct Meeting {
  explicit Meeting(std::uint32_t count) : barrier(count), bytes(count), sizes(count) {}
  std::barrier<> barrier;
  std::vector<std::span<const char>> bytes;
  std::vector<Sizes> sizes;
};

class ThreadRank final : public Ranks {
 public:
  ThreadRank(Meeting& meeting, std::uint32_t rank) : meeting_(meeting), rank_(rank) {}
  std::uint32_t rank() const override { return rank_; }
  std::uint32_t size() const override { return static_cast<std::uint32_t>(meeting_.bytes.size()); }
  std::string share(std::string bytes) override { return gather_all(bytes).front(); }
  void send(const std::string& /*bytes*/) override { FAIL(); }
  std::optional<std::string> take() override { return std::nullopt; }
  [[noreturn]] void abort(int /*exit_code*/) override { std::abort(); }

  using Ranks::gather;
  void gather(std::span<const char> mine, std::span<char> all, Sizes sizes) override {
    give(mine, {});
    auto to = all.begin();
    for (std::uint32_t rank = 0; rank < size(); ++rank) {
      EXPECT_EQ(meeting_.bytes[rank].size(), sizes[rank]);
      to = std::ranges::copy(meeting_.bytes[rank], to).out;
    }
    EXPECT_EQ(to, all.end());
    meeting_.barrier.arrive_and_wait();
  }
  void exchange(std::span<const char> out, Sizes out_sizes, std::span<char> in,
                Sizes in_sizes) override {
    give(out, out_sizes);
    auto to = in.begin();
    for (std::uint32_t rank = 0; rank < size(); ++rank) {
      EXPECT_EQ(meeting_.sizes[rank][rank_], in_sizes[rank]);
      to = std::ranges::copy(
               meeting_.bytes[rank].subspan(begin_of(meeting_.sizes[rank], rank_), in_sizes[rank]),
               to)
               .out;
    }
    EXPECT_EQ(to, in.end());
    meeting_.barrier.arrive_and_wait();
  }

 private:
  std::vector<std::string> gather_all(const std::string& bytes) { return gather(bytes); }
  void give(std::span<const char> bytes, Sizes sizes) {
    meeting_.bytes[rank_] = bytes;
    meeting_.sizes[rank_] = sizes;
    meeting_.barrier.arrive_and_wait();
  }

  Meeting& meeting_;
  std::uint32_t rank_;
};

/// work(rank) in each of `count` ranks.
template <class Work>
void in_ranks(std::uint32_t count, Work&& work) {
  Meeting meeting(count);
  std::vector<std::jthread> threads;
  for (std::uint32_t rank = 0; rank < count; ++rank) {
    threads.emplace_back([&meeting, &work, rank] {
      ThreadRank ranks(meeting, rank);
      work(ranks);
    });
  }
}

}  // namespace eagerx::train
