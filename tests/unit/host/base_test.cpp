// runtime/host/base: what programs for Linux have in common.
#include <gtest/gtest.h>
#include <pthread.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "runtime/host/base/hash.hpp"
#include "runtime/host/base/json.hpp"
#include "runtime/host/base/number.hpp"
#include "runtime/host/base/thread_pool.hpp"

namespace eagerx::host {
namespace {

TEST(ThreadPool, EveryMemberDoesTheJob) {
  ThreadPool pool(3);
  std::vector<int> done(3);
  for (int again = 0; again < 200; ++again) pool.run(3, [&](unsigned i) { ++done[i]; });
  for (int again = 0; again < 200; ++again) pool.run(2, [&](unsigned i) { ++done[i]; });
  pool.run(1, [&](unsigned i) { ++done[i]; });
  EXPECT_EQ(done, (std::vector<int>{401, 400, 200}));
}

// Turns in which all must come, some may, and not all are asked, one after another: a thread that
// comes late finds another turn and takes no part in the one that is over.
TEST(ThreadPool, WhatIsSharedIsDoneOnceWhoeverComes) {
  ThreadPool pool(4);
  std::array<std::atomic<int>, 4> done{};
  int parts = 0;
  for (int again = 0; again < 2000; ++again) {
    std::atomic<int> next = 0;
    const auto few = static_cast<unsigned>(1 + again % 4);
    pool.share(few, [&](unsigned i) {
      ASSERT_LT(i, few);
      while (next++ < 3) ++done[i];
    });
    parts += 3;
    if (again % 8 == 0) pool.run(4, [&](unsigned i) { ++done[i]; });
  }
  EXPECT_EQ(done[0] + done[1] + done[2] + done[3], parts + 4 * 250);
  for (const auto& each : done) EXPECT_GE(each, 250);
  EXPECT_THROW(pool.share(4,
                          [](unsigned i) {
                            if (i == 0) throw std::runtime_error("no");
                          }),
               std::runtime_error);
}

// Before, what the caller's own job threw left the others at work on what was gone.
TEST(ThreadPool, WhatAJobThrowsComesWhenAllHaveReturned) {
  ThreadPool pool(3);
  for (const unsigned which : {0U, 2U}) {
    std::vector<int> done(3);
    const auto fails = [&](unsigned i) {
      ++done[i];
      if (i == which) throw std::runtime_error("no");
    };
    EXPECT_THROW(pool.run(3, fails), std::runtime_error);
    EXPECT_EQ(done, std::vector<int>(3, 1));
  }
  int done = 0;
  pool.run(1, [&](unsigned) { ++done; });
  EXPECT_EQ(done, 1);
}

TEST(ThreadPool, EveryPartIsDoneOnceAndTheFirstFailureComesBack) {
  ThreadPool pool(3);
  std::vector<int> done(50);
  for (int again = 0; again < 200; ++again)
    pool.run_parts(done.size(), [&](std::size_t part) { ++done[part]; });
  EXPECT_EQ(done, std::vector<int>(50, 200));
  const auto fails = [&](std::size_t part) {
    ++done[part];
    if (part % 2 == 1) throw std::runtime_error(std::to_string(part));
  };
  try {
    pool.run_parts(6, fails);
    ADD_FAILURE();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "1");
  }
  EXPECT_EQ(done[4], 201);  // the others are done
  pool.run_parts(1, [&](std::size_t part) { ++done[part]; });
  EXPECT_EQ(done[0], 202);
  pool.run_parts(0, [&](std::size_t part) { ++done[part]; });
}

/// While it lives, no thread can be made.
class NoThreads {
 public:
  NoThreads() {
    pthread_getattr_default_np(&before_);
    pthread_attr_t huge;
    pthread_attr_init(&huge);
    pthread_attr_setstacksize(&huge, std::size_t{1} << 50U);  // no system has that
    pthread_setattr_default_np(&huge);
  }
  NoThreads(const NoThreads&) = delete;
  NoThreads& operator=(const NoThreads&) = delete;
  ~NoThreads() { pthread_setattr_default_np(&before_); }

 private:
  pthread_attr_t before_{};
};

// On 0d2dc587 an exception, and the end of the program if some threads had started.
TEST(ThreadPool, WorksWithTheThreadsThatThereAre) {
  std::vector<int> done(5);
  const auto work = [&](std::size_t part) { ++done[part]; };
  {
    const NoThreads none;
    EXPECT_THROW(ThreadPool(3), std::system_error);
    ThreadPool pool(3, ThreadPool::Size::at_most);
    EXPECT_EQ(pool.size(), 1U);
    pool.run_parts(done.size(), work);
  }
  EXPECT_EQ(done, std::vector<int>(5, 1));
}

TEST(Hash, IsFnv1a) {
  EXPECT_EQ(fnv1a(""), 0xcbf29ce484222325U);
  EXPECT_EQ(fnv1a("a"), 0xaf63dc4c8601ec8cU);  // as published
  EXPECT_EQ(fnv1a("b", fnv1a("a")), fnv1a("ab"));
  EXPECT_EQ(hex_text(0x0123456789abcdefU), "0x0123456789abcdef");
}

TEST(Number, ReadsBackToTheSameBits) {
  EXPECT_EQ(number_text(0.1F), "0.1");
  EXPECT_EQ(number_text(1.0 / 3.0), "0.3333333333333333");
  EXPECT_EQ(number_text(std::int64_t{-7}), "-7");
  double value = 5.0;
  EXPECT_TRUE(read_number("0.3333333333333333", 0.0, 1.0, value));
  EXPECT_EQ(value, 1.0 / 3.0);
  for (const char* wrong : {"", " 1", "1 ", "1x", "-0.5", "1.5", "nan", "inf", "0x1"}) {
    EXPECT_FALSE(read_number(wrong, 0.0, 1.0, value)) << wrong;
    EXPECT_EQ(value, 1.0 / 3.0) << wrong;
  }
}

TEST(Json, WritesWhatIsSaid) {
  Json json;
  json.begin_object().key("a\"b\\c\n").begin_list().whole(3).number(0.5F).boolean(true);
  json.number(std::numeric_limits<double>::infinity()).begin_object().end_object().end_list();
  json.key("text").text("\x1f\xc3\xa4").end_object();
  EXPECT_EQ(json.str(),
            "{\"a\\\"b\\\\c\\u000a\": [3, 0.5, true, null, {}], \"text\": "
            "\"\\u001f\xc3\xa4\"}");
}

}  // namespace
}  // namespace eagerx::host
